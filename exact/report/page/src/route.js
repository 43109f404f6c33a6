// The state of the page is its fragment: `#/case/17?zoom=-40`. Every state is a link.

/** The parts of a fragment's path and its parameters. */
export function parse(fragment) {
  const [path, query = ''] = fragment.replace(/^#\/?/, '').split('?');
  const decode = (part) => {
    try {
      return decodeURIComponent(part);
    } catch {
      return part;
    }
  };
  return {path: path.split('/').filter(Boolean).map(decode), query: new URLSearchParams(query)};
}

/** The fragment of a state: to('case', 17, {zoom: -40}). Parameters that are null or undefined are left out. */
export function to(...parts) {
  const last = parts.at(-1);
  const query = last !== null && typeof last === 'object' ? parts.pop() : {};
  const text = new URLSearchParams(Object.entries(query).filter(([, value]) => value !== null && value !== undefined))
                   .toString();
  return `#/${parts.map(encodeURIComponent).join('/')}${text && '?' + text}`;
}

/** Changes parameters of the present state without a new entry in the history, and without drawing anew. */
export function note(changes) {
  const {path, query} = parse(location.hash);
  const all = {...Object.fromEntries(query), ...changes};
  history.replaceState(null, '', to(...path, all));
}
