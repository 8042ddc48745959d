// For compilers from TypeScript 5.2 on, which know `using`.
/// <reference lib="esnext.disposable" />
export * from "./index.js";

declare module "./index.js" {
  interface FlowComplex {
    /** delete(), where `using` ends. */
    [Symbol.dispose](): void;
  }
}
