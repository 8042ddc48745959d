"""How the adapters in Python are asked: a stream of cases, or one file after the other.

    ADAPTER KIND                   answers cases on standard input (src/cli/manual/cases.md)
    ADAPTER KIND --serve SOCKET    answers files of points, for ask.py, which `fuzz` and `conformance` run
    ADAPTER KIND IN OUT            answers one file

The libraries take longer to load than to answer. So they are loaded once, and each case is answered by a fork of the
process: one that crashes, or hangs, is one refusal and no more.
"""

import json
import os
import signal
import socket
import sys

MOST_SECONDS = 3


def rows_of(lines):
    return [[float(word) for word in line.split()[:3]] for line in lines if line.strip() and not line.startswith("#")]


def in_a_fork(work):
    """What `work` returns, as ("answer", text), ("refused", reason) or ("crashed", number of the signal)."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        signal.alarm(MOST_SECONDS)
        try:
            answer = ["answer", work()]
        except BaseException as error:  # a panic of a library is a refusal, too
            answer = ["refused", f"{type(error).__name__}: {error}".replace("\n", " ")]
        with os.fdopen(writer, "w") as out:
            json.dump(answer, out)
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader) as answer:
        text = answer.read()
    _, status = os.waitpid(child, 0)
    if os.WIFSIGNALED(status):
        return "crashed", os.WTERMSIG(status)
    return tuple(json.loads(text))


def answer_stream(answer_of):
    lines = iter(sys.stdin)
    for line in lines:
        words = line.split()
        if words[:1] != ["case"]:
            continue
        rows = rows_of([next(lines) for _ in range(int(words[2]))])
        outcome, what = in_a_fork(lambda rows=rows: answer_of(rows))
        if outcome == "answer":
            print(f"answer {words[1]}\n{what}end", flush=True)
        else:
            print(f"refused {words[1]} {'crashed: signal ' if outcome == 'crashed' else ''}{what}", flush=True)


def answer_file(answer_of, points, out):
    with open(points) as lines:
        rows = rows_of(lines)
    outcome, what = in_a_fork(lambda: answer_of(rows))
    if outcome == "answer":
        with open(out, "w") as file:
            file.write("# an answer\n" + what)
    return outcome, what


def serve(answer_of, path):
    """A fork for each request, a line of JSON [IN, OUT]; the reply is [outcome, what]."""
    signal.signal(signal.SIGCHLD, signal.SIG_IGN)
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(path)
        server.listen(64)
        while True:
            connection, _ = server.accept()
            if os.fork() == 0:
                signal.signal(signal.SIGCHLD, signal.SIG_DFL)
                with connection, connection.makefile("rw") as stream:
                    points, out = json.loads(stream.readline())
                    outcome, what = answer_file(answer_of, points, out)
                    json.dump([outcome, None if outcome == "answer" else what], stream)
                os._exit(0)
            connection.close()


def main(kinds, answer_of):
    """`answer_of(kind, rows)` is the text of an answer."""
    if len(sys.argv) not in (2, 4) or sys.argv[1] not in kinds:
        sys.exit(f"usage: {sys.argv[0]} {'|'.join(kinds)} [IN OUT | --serve SOCKET]")

    def answer(rows):
        return answer_of(sys.argv[1], rows)

    if len(sys.argv) == 2:
        answer_stream(answer)
    elif sys.argv[2] == "--serve":
        serve(answer, sys.argv[3])
    else:
        outcome, what = answer_file(answer, sys.argv[2], sys.argv[3])
        if outcome != "answer":
            sys.exit(f"{outcome}: {what}")
