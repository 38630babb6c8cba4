// All tools of the page. A new one is a file beside this one and a line here.

import { landmarks } from './landmarks';
import type { PatternTool } from './PatternTool';
import { pick } from './pick';
import { pin } from './pin';
import { pieces } from './pieces';
import { places } from './places';
import { points } from './points';
import { probe } from './probe';
import { pull } from './pull';
import type { SceneTool } from './SceneTool';
import { range } from './range';
import { select } from './select';
import { sew } from './sew';

/** Of the 2D view, as their buttons stand. The first is held when all others have been put down. */
export const patternTools: readonly PatternTool[] = [pieces, points, sew, range];

/** Of the 3D view: what comes earlier is asked first. */
export const sceneTools: readonly SceneTool[] = [pick, landmarks, places, pull, pin, probe, select];

/** The tool of the 2D view that the state names. */
export const toolOf = (id: string): PatternTool => patternTools.find((tool) => tool.id === id) ?? pieces;
