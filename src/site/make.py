#!/usr/bin/env python3
"""The site, of what the repository and a build have.

usage: make.py BUILD

Guarantees: BUILD/site/ is the whole site; its sources are in BUILD/site-pages/, and what is copied as it is in
BUILD/site-files/. The program, the Python package and the reference of C++ are those of BUILD. Sphinx's warnings are
errors, so that a link to what is not there ends it. Files beyond MOST bytes, without the reference of C++, do, too.
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import PIL.Image

import gathered_pages
import scaling_plot

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUNNY = pathlib.Path("/usr/share/glmark2/models/bunny.obj")
EVERY = 15  # of the bunny's points that the front page shows
MOST = 10_000_000
# Debian 12's Sphinx has them for extensions of others; templates/base.html leaves them out. The theme's script is a
# module there, which browsers refuse from disk; what it adds is a switch of colours and a mark in the contents.
NOT_USED = ("jquery.js", "underscore.js", "_sphinx_javascript_frameworks_compat.js", "scripts/furo.js",
            "scripts/gumshoe-patched.js")
# Debian's theme asks a web server of Debian's for this file.
NORMALIZE = pathlib.Path("/usr/share/javascript/normalize.css/normalize.min.css")
PYTHON = "/usr/bin/python3"  # which knows Debian's packages


def run(*words, **options):
    return subprocess.run([str(word) for word in words], check=True, **options)


def manual_pages(build, folder):
    """A page of each command, of its manual page."""
    folder.mkdir()
    for roff in [*sorted((build / "share/man/man1").glob("*.1")), build / "oracle/proof/flowcert-proof.1"]:
        made = run("mandoc", "-T", "html", "-O", "fragment", roff, stdout=subprocess.PIPE, text=True).stdout
        made = re.sub(r"^<table class=\"(?:head|foot)\">.*?</table>\n?", "", made, flags=re.DOTALL | re.MULTILINE)
        made = re.sub(r"(</?)h([12])\b", lambda tag: f"{tag[1]}h{int(tag[2]) + 1}", made)
        made = re.sub(r"(?:<b>)?(flowcert[a-z-]*)(?:</b>)?\(1\)", r'<a href="\1.html">\1(1)</a>', made)
        made = re.sub(r"\n\s*\n", "\n", made)
        (folder / f"{roff.stem}.md").write_text(f"# {roff.stem}(1)\n\n```{{raw}} html\n{made}```\n", encoding="utf-8")


def live_bunny(build, page):
    """The viewer's page of every fifteenth point of the bunny, which a browser has drawn at once."""
    points = [line[1:] for line in BUNNY.read_text().splitlines() if line.startswith("v ")][::EVERY]
    with tempfile.TemporaryDirectory() as scratch:
        path = pathlib.Path(scratch, "bunny.xyz")  # the page tells its name
        path.write_text("\n".join(points))
        run(build / "flowcert", "view", path, "-o", page, stdout=subprocess.DEVNULL)


def notebooks(pages):
    """Pages of the tutorial as notebooks, to be run; a test runs them."""
    (pages / "notebooks").mkdir()
    run(PYTHON, ROOT / "src/site/notebooks.py", ROOT / "src/site/tutorial", pages / "notebooks")
    lines = ["# Notebooks\n",
             "Pages of the tutorial for Jupyter, each with a last cell that shows the viewer's page:\n"]
    lines += [f"- [{path.name}]({path.name})" for path in sorted((pages / "notebooks").glob("*.ipynb"))]
    lines.append("\nThey have no outputs yet; a test runs them, and compares what they print with the pages.")
    (pages / "notebooks/index.md").write_text("\n".join(lines) + "\n", encoding="utf-8")


def fewer_colors(pages):
    """Pictures with at most 256 colours, a third of the bytes."""
    for path in pages.rglob("*.png"):
        PIL.Image.open(path).convert("RGB").quantize(256).save(path, optimize=True)


def gather(build):
    """Everything but Sphinx's part. Returns whether the page that computes is there."""
    pages, files = build / "site-pages", build / "site-files"
    for folder in (pages, files):
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
    gathered_pages.Gathered(ROOT, pages).gather()
    manual_pages(build, pages / "commands")
    scaling_plot.draw((ROOT / "tests/bench/README.md").read_text(encoding="utf-8"), pages / "scaling.svg")
    notebooks(pages)
    run(PYTHON, ROOT / "src/site/tutorial/pictures.py", build / "flowcert", pages / "tutorial")
    fewer_colors(pages)
    live_bunny(build, files / "bunny.html")
    computing = ROOT / "build-wasm/flowcert.html"
    if computing.is_file():
        shutil.copyfile(computing, files / "flowcert.html")
    else:
        print("no build-wasm/flowcert.html: the site says how ./dev wasm makes the page that computes")
    shutil.copytree(build / "reference/html", files / "cpp")
    return computing.is_file()


def close(static):
    """Takes away what is not used, and what would be asked for elsewhere."""
    for script in NOT_USED:
        (static / script).unlink(missing_ok=True)
    sheet = static / "styles/furo.css"
    text = re.sub(r"@import url\(/javascript/normalize\.css/[^)]*\);", lambda _: NORMALIZE.read_text(),
                  sheet.read_text(encoding="utf-8"))
    sheet.write_text(text, encoding="utf-8")


def size_of(folder):
    return sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    is_computing = gather(build)
    site = build / "site"
    shutil.rmtree(site, ignore_errors=True)
    tags = ["-t", "computing"] if is_computing else []
    run(PYTHON, "-m", "sphinx", "-b", "html", "-q", "-W", "--keep-going", "-E", *tags, "-c", ROOT / "src/site",
        "-d", build / "site-doctrees", "-D", f"html_extra_path={build / 'site-files'}", build / "site-pages", site,
        env={"PYTHONPATH": str(build / "python"), "PATH": "/usr/bin:/bin", "LANG": "C.UTF-8", "HOME": str(build),
             "PYTHONDONTWRITEBYTECODE": "1"})
    close(site / "_static")
    cpp, whole = size_of(site / "cpp"), size_of(site)
    print(f"build/site/index.html: {(whole - cpp) / 1e6:.1f} MB, and {cpp / 1e6:.1f} MB of the reference of C++")
    if whole - cpp > MOST:
        sys.exit(f"without that reference it has {whole - cpp:,} bytes; at most {MOST:,}")
    return 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    sys.exit(main())
