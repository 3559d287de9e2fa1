function linearColour(hex) {
  return [1, 3, 5].map((at) => (parseInt(hex.slice(at, at + 2), 16) / 255) ** 2);
}

// Depth goes from the middle outwards, so its colours go one way too.
const kDepthStops = ['#0b3c6f', '#0072b2', '#56b4e9', '#bfe3d0', '#f0e442', '#e69f00', '#d55e00'];

/// The colours of tetrahedra, which come with the data, in linear light.
const linearPalette = [];

function setPalette(colours) {
  linearPalette.splice(0, linearPalette.length, ...colours.map(linearColour));
}

/// Twelve colours along the stops.
const kDepthPalette = Array.from({length: 12}, (_, i) => {
  const place = (i / 11) * (kDepthStops.length - 1);
  const at = Math.min(Math.floor(place), kDepthStops.length - 2);
  const [a, b] = [linearColour(kDepthStops[at]), linearColour(kDepthStops[at + 1])];
  return a.map((x, k) => x + (place - at) * (b[k] - x));
});

/// The colour of singular edges.
const kSingularColour = linearColour('#d01c1f');

/// Colours of annular cusps, those of parabolic edges, are counted from the last one on.
function lastPaletteColour(i) {
  return linearPalette[linearPalette.length - 1 - i % linearPalette.length];
}

/// Colour of tetrahedron i.
function paletteColour(i) { return linearPalette[i % linearPalette.length]; }
