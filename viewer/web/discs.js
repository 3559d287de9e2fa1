// The discs of arcs on the truncations, as a texture that both views read; see discs.glsl.
const kDiscTexelsPerRow = 2048;

/// The colour of a share of the scale of lengths, 0 to 1, linear light: straight between the stops.
function discScale(stops, share) {
  const place = Math.min(1, Math.max(0, share)) * (stops.length - 1);
  const low = Math.min(Math.floor(place), stops.length - 2);
  const part = (hex, at) => parseInt(hex.slice(at, at + 2), 16);
  return [1, 3, 5].map((at) => {
    const [from, to] = [part(stops[low], at), part(stops[low + 1], at)];
    return (Math.round(from + (place - low) * (to - from)) / 255) ** 2;
  });
}

class Discs {
  /// `data`: of the page; null if it has none.
  constructor(data, tiles) {
    this.exist = Boolean(data);
    this.tiles = data ? data.tiles : Array.from({length: tiles}, () => []);
    this.bare = data ? linearColour(data.bare) : [0, 0, 0];
    this.first = [];
    const numbers = [];
    for (const tile of this.tiles) {
      this.first.push(numbers.length / 4);
      for (let i = 0; i < tile.length; i += 5) {
        const [x, y, z, t, length] = tile.slice(i, i + 5);
        const share = (length - data.shortest) / (data.longest - data.shortest);
        numbers.push(x, y, z, t, ...discScale(data.colours, share), 4 / Math.expm1(2 * length));
      }
      numbers.push(0, 0, 0, 0, 0, 0, 0, -1);
    }
    this.numbers = numbers;
  }

  texture(graphics) { return graphics.dataTexture(this.numbers, kDiscTexelsPerRow, 1); }

  /// Tells a program of them; `texture` goes to unit 1.
  use(gl, program, texture, on) {
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.activeTexture(gl.TEXTURE0);
    gl.uniform1i(program.at('uDiscs'), 1);
    gl.uniform1i(program.at('uDiscsOn'), this.exist && on ? 1 : 0);
    gl.uniform3fv(program.at('uBareWall'), this.bare);
  }

  /// The length of the arc whose disc kIdentities tells of (discIdentity of discs.glsl), or null.
  lengthOf(tetrahedron, vertex, number) {
    return number >= 1 && number <= 14 ? this.tiles[4 * tetrahedron + vertex][5 * number - 1] : null;
  }
}

/// The scale of lengths beside the picture.
function showDiscScale(data) {
  element('discs-part').hidden = !data;
  if (!data) return;
  element('disc-scale').style.background = `linear-gradient(to right, ${data.colours.join(', ')})`;
  const steps = 4;
  for (let i = 0; i <= steps; ++i) {
    const label = document.createElement('span');
    label.textContent =
        Number((data.shortest + (i / steps) * (data.longest - data.shortest)).toPrecision(3));
    element('disc-lengths').append(label);
  }
}
