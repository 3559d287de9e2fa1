// The picture: the viewer's own scripts, on elements that are made anew for every manifold.
import {Page, fold, kContextOptions} from 'viewer';
import {byId} from './dom';
import type {Json} from './messages';

/** Beyond, the side panel would cover the picture. */
const kWide = '(min-width: 1280px)';

export class View {
  private page: Page | null = null;
  private prepared = false;

  /** `address`: the address's fragment for a view of the manifold. */
  constructor(private readonly address: (view: string) => string) {}

  get shown() { return this.page !== null; }
  get fragment() { return this.page?.fragment() ?? ''; }

  /** Makes the canvas and its context before there is anything to draw: the first context of a browser
   *  takes its time, above all where software draws. */
  prepare() {
    if (this.prepared) return;
    this.place();
    byId<HTMLCanvasElement>('picture').getContext('webgl2', kContextOptions);
    this.prepared = true;
  }

  private place() {
    for (const id of ['stage', 'controls', 'help']) {
      const template = byId<HTMLTemplateElement>(`template-${id}`);
      byId(`place-${id}`).replaceChildren(template.content.cloneNode(true));
    }
  }

  show(data: Json, fragment: string) {
    if (!this.prepared) {
      this.clear();
      this.place();
    }
    this.prepared = false;
    byId('no-picture').textContent = '';
    byId('workspace').dataset.picture = 'shown';
    const wishes = new URLSearchParams(fragment);
    if (!wishes.has('theme')) wishes.set('theme', document.documentElement.dataset.theme ?? 'light');
    this.page = new Page(data, wishes.toString(), this.address);
    this.page.start();
    fold(!matchMedia(kWide).matches);
    this.page.canvas.setAttribute('aria-label',
        `Picture of ${data.name || 'the manifold'}: the universal cover, or the view from inside. ` +
        'Arrow keys turn it, Help lists all keys.');
  }

  /** Takes the picture away, and says why there is none. */
  clear(reason = '') {
    byId('workspace').dataset.picture = reason ? 'none' : 'awaited';
    byId('no-picture').textContent = reason;
    if (this.prepared) return;
    this.page?.stop();
    this.page = null;
    for (const id of ['stage', 'controls', 'help']) byId(`place-${id}`).replaceChildren();
  }

  setTheme(name: string) {
    if (this.page && this.page.state.themeName !== name) this.page.act('theme');
  }
}
