#!/usr/bin/env python3
"""Makes the page that computes: one HTML file, with style, scripts, module and examples in it.

usage: bundle.py PACKAGE OUTPUT

PACKAGE is the folder of the npm package flowcert. Needs esbuild, and Debian's libcgal-demo for the bunny.
The page's policy allows two scripts by their hashes: its own, and that of the viewer's pages, which inherit the policy.
"""
import base64
import gzip
import hashlib
import pathlib
import re
import subprocess
import sys
import tarfile

SOURCE = pathlib.Path(__file__).resolve().parent
VIEWER = SOURCE.parents[1] / "viewer"
CAGE = SOURCE.parents[2] / "tests" / "inputs" / "cage.xyz"
ARCHIVE = "/usr/share/doc/libcgal-dev/examples.tar.gz"
BUNNY = "examples/Alpha_shapes_3/data/bunny_5000"


def bundled(name, package):
    """A classic script without `</script`. What the package has for Node and for check() stays outside."""
    command = ["esbuild", name, "--bundle", "--minify", "--format=iife", "--target=es2022", "--charset=ascii",
               "--legal-comments=none", "--log-level=error", f"--alias:flowcert={package / 'index.js'}",
               *(f"--external:{other}" for other in ("node:*", "module", "./check_module.js"))]
    return subprocess.run(command, cwd=SOURCE, check=True, stdout=subprocess.PIPE).stdout


def script_hash(script):
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"


def packed(name, content):
    data = base64.b64encode(gzip.compress(content, 9, mtime=0)).decode()
    return f'<script type="text/plain" id="{name}">{data}</script>\n'


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    package = pathlib.Path(sys.argv[1]).resolve()
    viewers = re.findall("<script>(.*?)</script>", (VIEWER / "page.html").read_text(), re.DOTALL)
    script = "\n" + bundled("page.js", package).decode("ascii")
    with tarfile.open(ARCHIVE) as archive:
        bunny = archive.extractfile(BUNNY).read()
    notices = [package / "NOTICES.md", package / "LICENSE", *sorted((package / "notices").iterdir())]
    data = {"module.wasm": (package / "flowcert_module.wasm").read_bytes(),
            "radii.wasm": (package / "radii_module.wasm").read_bytes(), "worker.js": bundled("worker.js", package),
            "bunny_5000.pts": bunny, "cube.xyz": (SOURCE / "cube.xyz").read_bytes(), "cage.xyz": CAGE.read_bytes(),
            "notices.txt": b"\n\n".join(text.read_bytes() for text in notices)}
    parts = {
        "HASHES": " ".join(map(script_hash, [*viewers, script])),
        "STYLE": (VIEWER / "page.css").read_text() + (SOURCE / "page.css").read_text(),
        "DATA": "".join(packed(name, content) for name, content in data.items()),
        "SCRIPT": script,
    }
    page = re.sub("@([A-Z]+)@", lambda name: parts[name[1]], (SOURCE / "page.html").read_text())
    pathlib.Path(sys.argv[2]).write_text(page)
    print(f"{sys.argv[2]}: {len(page):,} bytes")


if __name__ == "__main__":
    main()
