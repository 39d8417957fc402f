// node bundle.mjs MODULES OUT.cpp: bundles the page and writes it as the C++ file that defines page_parts() (page_parts.hpp).
// MODULES is the folder whose node_modules holds what package-lock.json lists.

import {readFileSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';

const [modules, out] = process.argv.slice(2);
const here = dirname(fileURLToPath(import.meta.url));
const require = createRequire(join(modules, 'package.json'));
const esbuild = require('esbuild');

async function script(name) {
  const result = await esbuild.build({
    entryPoints: [join(here, 'page', name)], bundle: true, minify: true, write: false, format: 'iife', target: ['es2022'], charset: 'ascii',
    nodePaths: [join(modules, 'node_modules')], legalComments: 'inline', logLevel: 'warning',
  });
  return result.outputFiles[0].text.replaceAll('</script', '<\\/script');
}

async function style() {
  const plots = readFileSync(require.resolve('uplot/dist/uPlot.min.css'), 'utf8');
  const result = await esbuild.transform(plots + readFileSync(join(here, 'page.css'), 'utf8'), {loader: 'css', minify: true});
  return result.code;
}

// A raw string literal has a length that all compilers take.
function pieces(text) {
  const list = [];
  for (let k = 0; k < text.length; k += 12000) list.push(`R"carom_page(${text.slice(k, k + 12000)})carom_page"`);
  return `{${list.join(',\n')}}`;
}

const page = readFileSync(join(here, 'page.html'), 'utf8');
const [top, body, middle, tail] = page.split(/<!--carom:\w+-->/);
const code = `#include "page_parts.hpp"

namespace carom::app {

const PageParts* page_parts() {
  static const PageParts parts{
${pieces(top + (await style()) + body)},
${pieces(middle)},
${pieces(await script('flat.js'))},
${pieces(await script('solid.js'))},
${pieces(tail)}};
  return &parts;
}

}  // namespace carom::app
`;
writeFileSync(out, code);
