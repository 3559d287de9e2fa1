// What was asked before: kept in this browser alone, and only as long as one wants.
import {sourceToFragment} from './address';
import type {Source} from './messages';

export interface Entry {
  fragment: string;
  name: string;
  note: string;
}

const kKey = 'tripus.history', kMost = 60;

let entries: Entry[] = read();

/** A browser may keep nothing for a page from a file; the history then ends with the page. */
function read(): Entry[] {
  try {
    const kept = JSON.parse(localStorage.getItem(kKey) ?? '[]');
    return Array.isArray(kept) ? kept.filter((one) => typeof one?.fragment === 'string').slice(0, kMost) : [];
  } catch {
    return [];
  }
}

function write() {
  try {
    localStorage.setItem(kKey, JSON.stringify(entries));
  } catch {
    // It is in memory.
  }
}

export const history = {
  all: (): readonly Entry[] => entries,

  /** The newest first; the same manifold once. */
  async add(source: Source, name: string, note: string) {
    const fragment = await sourceToFragment(source);
    if (fragment === null) return;
    entries = [{fragment, name, note}, ...entries.filter((one) => one.fragment !== fragment)].slice(0, kMost);
    write();
  },

  clear() {
    entries = [];
    write();
  },
};
