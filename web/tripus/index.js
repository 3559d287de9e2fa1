// The package: the front door with the module's bytes beside it, so that nothing is fetched.
import {setSource} from './tripus.js';

setSource(async () => {
  const {default: text} = await import('./wasm.js');
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
});

export {Manifold, TripusError, compiled, load, unpacked} from './tripus.js';
