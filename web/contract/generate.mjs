// npm run generate: makes the page's types anew.

import { mkdirSync, writeFileSync } from 'node:fs';
import { typesFile, typesText } from './types.mjs';

mkdirSync(new URL('.', typesFile), { recursive: true });
writeFileSync(typesFile, await typesText());
