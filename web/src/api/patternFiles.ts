// Where a project's pattern lies as a file to take home.

import type { Http } from './http';
import type { Paper } from './types';

export interface PatternUrls {
  /** As pages to print. */
  patternPdfUrl(projectId: string, paper: Paper): string;
  patternSvgUrl(projectId: string): string;
  patternDxfUrl(projectId: string): string;
}

const part = encodeURIComponent;

export function makePatternUrls(http: Http): PatternUrls {
  return {
    patternPdfUrl: (id, paper) => http.url(`/projects/${part(id)}/pattern.pdf?paper=${paper}`),
    patternSvgUrl: (id) => http.url(`/projects/${part(id)}/pattern.svg`),
    patternDxfUrl: (id) => http.url(`/projects/${part(id)}/pattern.dxf`),
  };
}
