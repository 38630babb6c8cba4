// Versions of a project: states that were named, to come back to them.

import { matching, type Http } from './http';
import type { Answer, Project, Question, Schemas } from './types';

export type Version = Schemas['Version'];

export interface VersionApi {
  /** Newest first. */
  versions(project: string): Promise<Version[]>;
  nameVersion(project: string, revision: number, name: string): Promise<Version>;
  /** One step of the history. */
  restoreVersion(project: string, revision: number, version: string): Promise<Project>;
  removeVersion(project: string, version: string): Promise<void>;
}

export function makeVersionApi(http: Http): VersionApi {
  const of = (project: string): string => `/projects/${encodeURIComponent(project)}/versions`;
  const one = (project: string, version: string): string => `${of(project)}/${encodeURIComponent(version)}`;
  return {
    versions: async (project) => (await http.get<Answer<'listVersions'>>(of(project))).versions,
    nameVersion: (project, revision, name) =>
      http.post(of(project), { name } satisfies Question<'nameVersion'>, matching(revision)),
    restoreVersion: (project, revision, version) =>
      http.post(`${one(project, version)}/restore`, undefined, matching(revision)),
    removeVersion: async (project, version) => void (await http.send(one(project, version), { method: 'DELETE' })),
  };
}
