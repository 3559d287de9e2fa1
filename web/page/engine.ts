// The worker as the page sees it: one question after the other, and a stop that always works.
import type {Failure, FromWorker, Json, Question, ToWorker} from './messages';

export class Problem extends Error {
  constructor(readonly kind: string, message: string) { super(message); }
}

export interface Reply {
  answers: Json[];
  /** As the program printed it. */
  text: string;
  seconds: number;
}

interface Waiting {
  id: number;
  question: Question;
  title: string;
  /** Nobody waits for it: it comes after all else, and the bar does not tell of it. */
  quiet: boolean;
  resolve: (reply: Reply) => void;
  reject: (problem: Problem) => void;
}

/** What is going on, for the bar at the top. */
export interface Work {
  title: string;
  activity: string;
  tetrahedra: number;
  since: number;
  waiting: number;
}

export class Engine {
  private worker: Worker | null = null;
  private ready = false;
  private next = 1;
  private queue: Waiting[] = [];
  private current: Waiting | null = null;
  private work: Work | null = null;
  private began = 0;
  private started = Promise.resolve();
  private broken = '';

  /**
   *   script  of the worker
   *   bytes   of the module, again for every worker
   *   heard   is called whenever the work changes; null: there is none
   */
  constructor(private readonly script: string, private readonly bytes: () => Promise<ArrayBuffer>,
              private readonly heard: (work: Work | null) => void) {}

  /** Starts the worker before anything is asked; resolves when it has what it needs. */
  start(): Promise<void> {
    if (!this.worker) this.started = this.begin();
    return this.started;
  }

  private async begin(): Promise<void> {
    const address = URL.createObjectURL(new Blob([this.script], {type: 'text/javascript'}));
    const worker = this.worker = new Worker(address);
    this.ready = false;
    worker.onmessage = (event) => {
      URL.revokeObjectURL(address);
      if (worker === this.worker) this.hear(event.data as FromWorker);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      if (worker === this.worker)
        this.fail(event.message || 'the worker of this page has ended');
    };
    try {
      const bytes = await this.bytes();
      if (worker === this.worker) this.tell({bytes});
    } catch (error: any) {
      this.fail(String(error.message ?? error));
    }
  }

  ask(title: string, question: Question, quiet = false): Promise<Reply> {
    return new Promise((resolve, reject) => {
      const first = this.queue.findIndex((one) => one.quiet);
      this.queue.splice(quiet || first < 0 ? this.queue.length : first, 0,
                        {id: this.next++, question, title, quiet, resolve, reject});
      void this.start();
      this.advance();
    });
  }

  /** Ends what is being computed and what waits; the next question goes to a fresh worker. */
  stop() {
    const ended = [this.current, ...this.queue];
    this.end();
    for (const one of ended) one?.reject(new Problem('stopped', 'Stopped.'));
    void this.start();
  }

  private end() {
    this.worker?.terminate();
    this.worker = null;
    this.current = null;
    this.queue = [];
    this.show(null);
  }

  private get waiting() { return this.queue.filter((one) => !one.quiet).length; }

  private tell(message: ToWorker) { this.worker?.postMessage(message); }

  private show(work: Work | null) {
    this.work = work;
    this.heard(work);
  }

  private advance() {
    if (this.current || !this.ready) {
      if (!this.current && this.waiting > 0 && !this.work)
        this.show({title: 'Starting', activity: '', tetrahedra: 0, since: performance.now(), waiting: 0});
      return;
    }
    const one = this.queue.shift();
    if (!one) {
      this.show(null);
      return;
    }
    this.current = one;
    this.began = performance.now();
    this.show(one.quiet ? null : {title: one.title, activity: '', tetrahedra: 0, since: this.began,
                                  waiting: this.waiting});
    this.tell({id: one.id, question: one.question});
  }

  private hear(message: FromWorker) {
    if ('ready' in message) {
      this.ready = true;
      performance.mark('module');  // bench/page.py
      this.advance();
      return;
    }
    if ('failed' in message) {
      this.fail(message.failed);
      return;
    }
    const one = this.current;
    if (!one || one.id !== message.id) return;
    if ('progress' in message) {
      if (this.work) this.show({...this.work, ...message.progress, waiting: this.waiting});
      return;
    }
    const seconds = (performance.now() - this.began) / 1000;
    this.current = null;
    if ('failure' in message) this.refuse(one, message.failure);
    else one.resolve({answers: message.answers, text: message.text, seconds});
    this.advance();
  }

  /** A module that ran out of memory, or failed, is not asked again. */
  private refuse(one: Waiting, {kind, message}: Failure) {
    if (kind === 'out-of-memory' || kind === 'internal') {
      const rest = this.queue;
      this.end();
      this.queue = rest;
      void this.start();
    }
    one.reject(new Problem(kind, message));
  }

  private fail(message: string) {
    const ended = [this.current, ...this.queue];
    const first = !this.broken;
    this.broken = message;
    this.end();
    const text = `This page cannot compute here: ${message}`;
    for (const one of ended) one?.reject(new Problem('internal', text));
    if (first && ended.every((one) => !one)) this.heard(null);
  }
}
