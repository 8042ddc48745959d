// run_wasi.mjs FILE…: runs a program of WebAssembly that asks for nothing but WASI. Its exit status is the program's.
import { readFile } from "node:fs/promises";
import { WASI } from "node:wasi";

const wasi = new WASI({ version: "preview1", args: process.argv.slice(2), env: process.env });
const module = await WebAssembly.compile(await readFile(process.argv[2]));
const imports = wasi.getImportObject();
for (const { module: from, name } of WebAssembly.Module.imports(module)) {
  imports[from] ??= {};
  // emscripten's own, such as the news that memory grew, and setjmp, which returns 0
  imports[from][name] ??= () => 0;
}
process.exit(wasi.start(await WebAssembly.instantiate(module, imports)));
