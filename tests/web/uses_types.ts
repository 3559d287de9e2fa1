// What the types of the package allow and refuse; newcomer.mjs compiles it.
import { Manifold, TripusError, load, unpacked, compiled, type Input, type Answer, type Tripus, type ErrorKind } from "tripus";
const M: Manifold = await Manifold.from({ name: "a", content: new Uint8Array(3), label: "b" }, { timeLimit: 3, stop: () => false, progress: (a: string, t: number) => void a });
const v: number = M.volume(); const s: string = M.isometrySignature(); const h: string = M.homology();
const c: Manifold[] = M.covers(2, { cyclic: true, limit: 3, timeLimit: 1 });
const iso: boolean | undefined = M.isIsometricTo(c[0]!);
const e: Answer | null = M.identify();
const t: Tripus = await load(await compiled());
const r = t.run(["solve", "cPcbbbihq"], { files: { a: "x" }, stdin: "y" });
const st: number = r.status; const f: Uint8Array | undefined = r.files["a"];
try { M.lengths.map((x) => x.toFixed()); M.dihedralAngles[0]!.length; } catch (error) { if (error instanceof TripusError) { const k: ErrorKind = error.kind; if (k === "no-metric") throw error; } }
const i: Input = "x"; await unpacked("x"); M.pageData({ cells: 3, model: "klein", discs: 2 }); M.embedding({ cells: 2 }); M.orthospectrum({ length: 3, words: true });
// @ts-expect-error
M.covers("2");
// @ts-expect-error
await Manifold.from(5);
// @ts-expect-error
new Manifold();
// @ts-expect-error
M.pageData({ model: "nope" });
export { v, s, h, iso, e, st, f, i };
