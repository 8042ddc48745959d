"""Builds a proved program of spec/proofs/ in BUILD/proofs/, with all that its proof rests on.

There are two, the judge of records and the checker of certificates. Where a proof does not compile there is no program.
Needs coqc, coq_makefile, make and ocamlfind with zarith.
"""
import pathlib
import shutil
import subprocess

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "spec" / "proofs"
THEOREMS = {"judge": "judge/Sound.vo", "checker": "checker/Verdict.vo"}


def built(name, build):
    """The path of the program. A step that fails raises CalledProcessError, with what was printed in its stdout."""
    folder = pathlib.Path(build).resolve() / "proofs"
    shutil.copytree(SOURCE, folder, dirs_exist_ok=True)
    sources = [f"{name}_extracted.mli", f"{name}_extracted.ml", f"{name}_main.ml"]
    for command, place in [(["coq_makefile", "-f", "_CoqProject", "-o", "Makefile"], folder),
                           (["make", "-j2", THEOREMS[name], f"{name}/Extract.vo"], folder),
                           (["ocamlfind", "ocamlopt", "-package", "zarith", "-linkpkg", *sources, "-o", name],
                            folder / name)]:
        subprocess.run(command, cwd=place, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return folder / name / name
