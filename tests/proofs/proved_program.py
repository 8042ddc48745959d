"""Builds the judge of spec/proofs/ in BUILD/proofs/, with all that its proof rests on.

Where a proof does not compile there is no judge. Needs coqc, coq_makefile, make and ocamlfind with zarith.
"""
import pathlib
import shutil
import subprocess

SOURCE = pathlib.Path(__file__).resolve().parents[2] / "spec" / "proofs"
SOURCES = ["judge_extracted.mli", "judge_extracted.ml", "judge_main.ml"]


def built_judge(build):
    """The path of the program. A step that fails raises CalledProcessError, with what was printed in its stdout."""
    folder = pathlib.Path(build).resolve() / "proofs"
    shutil.copytree(SOURCE, folder, dirs_exist_ok=True)
    for command, place in [(["coq_makefile", "-f", "_CoqProject", "-o", "Makefile"], folder),
                           (["make", "-j2", "judge/Sound.vo", "judge/Extract.vo"], folder),
                           (["ocamlfind", "ocamlopt", "-package", "zarith", "-linkpkg", *SOURCES, "-o", "judge"],
                            folder / "judge")]:
        subprocess.run(command, cwd=place, check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return folder / "judge" / "judge"
