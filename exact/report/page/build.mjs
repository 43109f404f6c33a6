// Makes report.html, one self-contained file, of template.html, style.css and src/: `npm ci && npm run build`.
// The result is committed, so that the program can be built without npm.
import {build} from 'esbuild';
import {createHash} from 'node:crypto';
import {readdir, readFile, writeFile} from 'node:fs/promises';

const here = (name) => new URL(name, import.meta.url);
const read = (name) => readFile(here(name), 'utf8');

const limit = 1.5e6;  // bytes

async function bundled(entry) {
  const result = await build({
    entryPoints: [here(entry).pathname],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2022',
    loader: {'.css': 'css'},
    legalComments: 'none',
    logLevel: 'warning',
  });
  return result.outputFiles[0].text.trim();
}

/** The licences of what is built in, each with name and version, as one comment. */
async function notices() {
  const names = Object.keys(JSON.parse(await read('package.json')).dependencies);
  const texts = await Promise.all(names.map(async (name) => {
    const {version, license} = JSON.parse(await read(`node_modules/${name}/package.json`));
    return `${name} ${version} (${license})\n\n${(await read(`node_modules/${name}/LICENSE`)).trim()}\n`;
  }));
  return texts.join('\n');
}

/** A hash of all that the page is made of; tests/report/bundle.sh makes it again, without npm. */
async function hashOfSources() {
  const modules = (await readdir(here('src/'))).sort().map((name) => `src/${name}`);
  const hash = createHash('sha256');
  for (const name of ['build.mjs', 'package-lock.json', ...modules, 'style.css', 'template.html'])
    hash.update(`${name}\n`).update(await readFile(here(name)));
  return hash.digest('hex');
}

// A function as replacement, since a string would have its $ interpreted.
const put = (text, mark, value) => {
  if (text.split(mark).length !== 2) throw new Error(`template.html: ${mark} must stand in it once`);
  return text.replace(mark, () => value);
};

const script = (await bundled('src/main.js')).replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const licences = await notices();
let page = await read('template.html');
page = put(page, '/*STYLE*/', await bundled('style.css'));
page = put(page, '/*SCRIPT*/', script);
page = put(page, 'SOURCES', await hashOfSources());
page = put(page, 'LICENCES', licences.replaceAll('&', '&amp;').replaceAll('<', '&lt;'));
if (Buffer.byteLength(page) > limit)
  throw new Error(`report.html would have ${Buffer.byteLength(page)} bytes, more than ${limit}`);
await writeFile(here('report.html'), page);
await writeFile(here('LICENCES.txt'), `What report.html carries of others.\n\n${licences}`);
console.log(`report.html: ${Buffer.byteLength(page)} bytes`);
