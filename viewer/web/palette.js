// The colours of Okabe and Ito, which colour-blind people tell apart, in linear light; the first
// two are those of the two tetrahedra of the tripus.
const kPalette = ['#56b4e9', '#e69f00', '#009e73', '#cc79a7', '#f0e442', '#0072b2', '#d55e00',
                  '#8fd0c0', '#b9a3e3', '#c9b458', '#7f9fb5', '#e6a18a'];

function linearColour(hex) {
  return [1, 3, 5].map((at) => (parseInt(hex.slice(at, at + 2), 16) / 255) ** 2);
}

// Depth goes from the middle outwards, so its colours go one way too.
const kDepthStops = ['#0b3c6f', '#0072b2', '#56b4e9', '#bfe3d0', '#f0e442', '#e69f00', '#d55e00'];

const kLinearPalette = kPalette.map(linearColour);

/// Twelve colours along the stops.
const kDepthPalette = Array.from({length: 12}, (_, i) => {
  const place = (i / 11) * (kDepthStops.length - 1);
  const at = Math.min(Math.floor(place), kDepthStops.length - 2);
  const [a, b] = [linearColour(kDepthStops[at]), linearColour(kDepthStops[at + 1])];
  return a.map((x, k) => x + (place - at) * (b[k] - x));
});

/// Colour of entry i: the palette again and again, each time a little darker.
function paletteColour(i) {
  const round = Math.floor(i / kPalette.length) % 4;
  return kLinearPalette[i % kPalette.length].map((c) => c * Math.pow(0.72, round));
}
