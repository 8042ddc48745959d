"""ask.py SOCKET IN OUT: has the adapter behind the socket answer a file of points.

It ends as the adapter's process did: with 0, with 3 and a reason, or by the same signal.
It runs once for each case, so it is started with `python3 -I -S`, and loads next to nothing.
"""

import json
import os
import socket
import sys

with socket.socket(socket.AF_UNIX) as connection:
    connection.connect(sys.argv[1])
    with connection.makefile("rw") as stream:
        stream.write(json.dumps([os.path.abspath(path) for path in sys.argv[2:4]]) + "\n")
        stream.flush()
        outcome, what = json.load(stream)
if outcome == "crashed":
    os.kill(os.getpid(), what)
if outcome == "refused":
    print(what, file=sys.stderr)
    sys.exit(3)
