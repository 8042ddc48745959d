#!/usr/bin/env python3
"""Makes page.html, the page that `flowcert view` fills: template, style, and the bundled script, in one file.

usage: bundle.py BUILD_DIR [--check]

BUILD_DIR gets three.js from npm, by package-lock.json; nothing else is written but page.html beside this file.
With --check nothing is written, and the exit status is 1 where page.html is not what the command makes.
The page has one classic script, in which `</script` does not occur, and three's whole licence in a comment.
The same sources and the same esbuild make the same bytes.
The comment has the SHA-256 of the sources, so that a page that is older than they are is found without npm.
"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent
DATA_LINE = '<script type="application/json" id="flowcert-data">null</script>\n'


def installed_three(build):
    """The folder of node_modules with the version of package-lock.json."""
    lock = json.loads((SOURCE / "package-lock.json").read_text())["packages"]["node_modules/three"]
    package = build / "node_modules" / "three" / "package.json"
    if not package.is_file() or json.loads(package.read_text())["version"] != lock["version"]:
        build.mkdir(parents=True, exist_ok=True)
        for name in ("package.json", "package-lock.json"):
            shutil.copy(SOURCE / name, build / name)
        subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=build, check=True,
                       stdout=subprocess.DEVNULL)
    return build / "node_modules"


def bundled_script(modules):
    command = ["esbuild", "main.js", "--bundle", "--minify", "--format=iife", "--target=es2021", "--charset=ascii",
               "--legal-comments=none", "--log-level=warning"]
    made = subprocess.run(command, cwd=SOURCE, env={**os.environ, "NODE_PATH": str(modules)}, check=True,
                          stdout=subprocess.PIPE)
    script = made.stdout.decode("ascii")
    for forbidden in ("</script", "<!--"):
        if forbidden in script.lower():
            sys.exit(f"the bundled script contains {forbidden}")
    return script


def sources_digest(source=SOURCE):
    """SHA-256 of all that makes the page, this file too, but for three.js, whose version package-lock.json has."""
    names = ["LICENSE", "bundle.py", "package-lock.json", "package.json", "page.css", "page_template.html"]
    digest = hashlib.sha256()
    for path in sorted([*(source / name for name in names), *source.glob("*.js")]):
        content = path.read_bytes()
        digest.update(f"{path.name} {len(content)}\n".encode() + content)
    return digest.hexdigest()


def page(build):
    modules = installed_three(build)
    parts = {
        "VERSION": json.loads((SOURCE / "package.json").read_text())["version"],
        "THREE_VERSION": json.loads((modules / "three" / "package.json").read_text())["version"],
        "SOURCES": sources_digest(),
        "LICENSE": (SOURCE / "LICENSE").read_text(),
        "THREE_LICENSE": (modules / "three" / "LICENSE").read_text(),
        "STYLE": (SOURCE / "page.css").read_text(),
        "SCRIPT": bundled_script(modules),
    }
    text = (SOURCE / "page_template.html").read_text()
    for name, part in parts.items():
        before, found, after = text.partition(f"@{name}@")
        if not found:
            sys.exit(f"page_template.html has no @{name}@")
        text = before + part + after
    if text.count(DATA_LINE) != 1:
        sys.exit("the page must have the line of the data once")
    return text.encode()


def main():
    arguments = [a for a in sys.argv[1:] if a != "--check"]
    if len(arguments) != 1:
        sys.exit(__doc__)
    made = page(pathlib.Path(arguments[0]).resolve())
    target = SOURCE / "page.html"
    if "--check" in sys.argv:
        if not target.is_file() or target.read_bytes() != made:
            sys.exit("src/viewer/page.html is not what ./dev viewer makes")
        print(f"src/viewer/page.html is what ./dev viewer makes, {len(made):,} bytes")
        return
    target.write_bytes(made)
    print(f"src/viewer/page.html: {len(made):,} bytes")


if __name__ == "__main__":
    main()
