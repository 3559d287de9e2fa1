// Surfaces and meshes in files: to make a triangulation of them needs the program.

const text = (bytes: Uint8Array, count = 400) =>
    new TextDecoder('latin1').decode(bytes.subarray(0, count));

/** The format of a surface or mesh, or null: what else it is, the module finds out. */
export function surfaceFormat(name: string, bytes: Uint8Array): string | null {
  const start = text(bytes).trimStart();
  if (/^(ST)?C?N?4?n?OFF\b/.test(start)) return 'OFF';
  if (/^ply\s/.test(start)) return 'PLY';
  if (/^# vtk DataFile/.test(start)) return 'VTK';
  if (/<VTKFile\b/.test(start)) return 'VTK XML';
  if (/^\$MeshFormat/.test(start)) return 'Gmsh';
  if (/^MeshVersionFormatted/.test(start)) return 'Medit';
  if (/^solid\b/i.test(start) && /\bfacet\b/i.test(text(bytes, 2000))) return 'STL';
  // Binary: 80 bytes of anything, a count, 50 bytes for each triangle.
  if (bytes.length >= 84) {
    const count = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
    const whole = 84 + 50 * count;
    if (bytes.length === whole || (/\.stl$/i.test(name) && bytes.length > whole)) return 'STL';
  }
  if (/\.obj$/i.test(name) && /^\s*(v|vn|f|o|g|mtllib)\s/m.test(text(bytes, 4000))) return 'OBJ';
  if (/\.(node|ele)$/i.test(name)) return 'TetGen';
  return null;
}

/** What to do with it. */
export const surfaceAdvice = (name: string, format: string) =>
    `${name} is a surface or a mesh (${format}). The page takes triangulations; the program makes one of it: ` +
    `tripus mesh ${/^[\w.+-]+$/.test(name) ? name : `'${name.replaceAll("'", "'\\''")}'`} -o triangulation.json. ` +
    'Then drop triangulation.json here.';
