// All that the page says, in German. It is fetched when it is wanted.

import type { Texts } from './en';
import { admin } from './de/admin';
import { arrange } from './de/arrange';
import { body } from './de/body';
import { common } from './de/common';
import { drape } from './de/drape';
import { edits } from './de/edits';
import { fabric } from './de/fabric';
import { frame } from './de/frame';
import { imports } from './de/imports';
import { intake } from './de/intake';
import { keys } from './de/keys';
import { messages } from './de/messages';
import { names } from './de/names';
import { outcome } from './de/outcome';
import { pattern } from './de/pattern';
import { report } from './de/report';
import { scene } from './de/scene';
import { section } from './de/section';
import { share } from './de/share';
import { sweep } from './de/sweep';
import { tour } from './de/tour';
import { versions } from './de/versions';

export const de: Texts = {
  admin,
  arrange,
  body,
  common,
  drape,
  edits,
  fabric,
  frame,
  imports,
  intake,
  keys,
  messages,
  names,
  outcome,
  pattern,
  report,
  scene,
  section,
  share,
  sweep,
  tour,
  versions,
};
