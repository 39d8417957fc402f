// Chromium with a page of `carom view` in it.

import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdirSync, mkdtempSync, rmSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';

const [carom, examples, modules, chromiumPath, out] = process.argv.slice(2).map((p) => resolve(p));
export {carom, examples};
const {chromium} = createRequire(join(modules, 'package.json'))('playwright-core');
mkdirSync(out, {recursive: true});

const ARGUMENTS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run',
  '--disable-background-networking', '--disable-component-update', '--disable-sync'];

export const file = (name) => join(out, name);

/** Runs carom; its standard output. */
export function run(...words) {
  const r = spawnSync(carom, words, {encoding: 'utf8', maxBuffer: 1e9});
  assert.equal(r.status, 0, r.stderr);
  return r.stdout;
}

/** The page of an example, written into the output folder. */
export function pageOf(name, ...words) {
  const page = file(name + '.html');
  run('view', join(examples, name), '--out', page, ...words);
  return page;
}

/** Calls f(page, problems) with a page that has drawn its figures; problems: what the console complained of. */
export async function withPage(address, options, f) {
  const profile = mkdtempSync(join(tmpdir(), 'carom-chromium-'));
  const context = await chromium.launchPersistentContext(profile, {executablePath: chromiumPath, headless: true, args: ARGUMENTS, ...options});
  try {
    context.setDefaultTimeout(120000); // a busy machine is no failure
    const page = context.pages()[0] ?? (await context.newPage());
    const problems = [];
    page.on('console', (message) => ['error', 'warning'].includes(message.type()) && !/GPU stall|swiftshader/i.test(message.text()) && problems.push(message.text()));
    page.on('pageerror', (error) => problems.push(error.message));
    await page.goto(address.includes('://') ? address : 'file://' + address);
    await page.waitForFunction(() => window.carom?.drawn);
    await f(page, problems);
  } finally {
    await context.close();
    rmSync(profile, {recursive: true, force: true});
  }
}

export const desktop = {viewport: {width: 1400, height: 900}, colorScheme: 'light'};
export const phone = {viewport: {width: 390, height: 844}, deviceScaleFactor: 2, hasTouch: true, colorScheme: 'dark'};
