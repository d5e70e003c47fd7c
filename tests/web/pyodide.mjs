// Runs a program in Pyodide with an extension module, and tells the text that it leaves.
import { readFileSync } from "node:fs";
import { loadPyodide } from "../../web/node_modules/pyodide/pyodide.mjs";

const { module, name, program } = JSON.parse(readFileSync(0, "utf8"));
const python = await loadPyodide();
python.FS.writeFile(name, readFileSync(module));
console.log(JSON.stringify(python.runPython(program)));
