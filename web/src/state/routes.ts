// What the address says is shown. Routes live behind the hash, so that the service serves one page only.

export type Route =
  | { name: 'home' }
  | { name: 'project'; id: string }
  | { name: 'job'; id: string }
  | { name: 'sweep'; id: string }
  | { name: 'compare'; left: string; right: string }
  | { name: 'admin' }
  | { name: 'shared'; secret: string }
  | { name: 'unknown'; path: string };

export function parseRoute(hash: string): Route {
  const path = hash.replace(/^#/, '');
  if (path === '' || path === '/') return { name: 'home' };
  if (path === '/admin') return { name: 'admin' };
  const two = /^\/compare\/([A-Za-z0-9_-]{1,64})\/([A-Za-z0-9_-]{1,64})$/.exec(path);
  if (two) return { name: 'compare', left: two[1]!, right: two[2]! };
  const shared = /^\/shared\/(\w{1,128})$/.exec(path);
  if (shared) return { name: 'shared', secret: shared[1]! };
  const match = /^\/(projects|jobs|sweeps)\/([A-Za-z0-9_-]{1,64})$/.exec(path);
  if (!match) return { name: 'unknown', path };
  const kind = { projects: 'project', jobs: 'job', sweeps: 'sweep' } as const;
  return { name: kind[match[1] as keyof typeof kind], id: match[2]! };
}

export function formatRoute(route: Route): string {
  switch (route.name) {
    case 'home':
      return '#/';
    case 'project':
      return `#/projects/${route.id}`;
    case 'job':
      return `#/jobs/${route.id}`;
    case 'sweep':
      return `#/sweeps/${route.id}`;
    case 'compare':
      return `#/compare/${route.left}/${route.right}`;
    case 'admin':
      return '#/admin';
    case 'shared':
      return `#/shared/${route.secret}`;
    case 'unknown':
      return `#${route.path}`;
  }
}
