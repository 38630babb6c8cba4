// All that the page says, in English: a section for each part of the page. The other languages have its type.

import { admin } from './en/admin';
import { arrange } from './en/arrange';
import { body } from './en/body';
import { common } from './en/common';
import { drape } from './en/drape';
import { edits } from './en/edits';
import { fabric } from './en/fabric';
import { frame } from './en/frame';
import { imports } from './en/imports';
import { intake } from './en/intake';
import { keys } from './en/keys';
import { messages } from './en/messages';
import { names } from './en/names';
import { outcome } from './en/outcome';
import { pattern } from './en/pattern';
import { report } from './en/report';
import { scene } from './en/scene';
import { section } from './en/section';
import { share } from './en/share';
import { sweep } from './en/sweep';
import { tour } from './en/tour';
import { versions } from './en/versions';

export const en = {
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

export type Texts = typeof en;
