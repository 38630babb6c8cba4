// What came of a drape, and the ways on.

import { grammar } from '../grammar';

const { number } = grammar('en');

export const outcome = {
  noResult: 'it ended without a result',
  failed: 'The drape failed',
  openWhy: 'Most often a seam is then sewn the wrong way round, or the body stands between its sides.',
  openUneven: 'One side of the widest is much longer than the other: it may end elsewhere, or a seam beside it is wanting. Else a seam is sewn the wrong way round.',
  notWorn: 'It is not worn as it should be',
  leftOutWhy: 'Nothing holds them to the rest, or the garment could not be put on with them, so it was draped without them.',
  leftOutSewn: 'They are sewn on, but the garment could not be put on with them, so it was draped without them. Standing elsewhere at the start, they may come along.',
  moved: 'It still moved at the end',
  movedWhy: 'Its time was up before it came to rest. What is seen is its last moment; wide and light cloth takes longest.',
  andMore: ' and more',
  older: 'Changed since this drape',
  cancelled: 'The drape was cancelled',
  fixes: {
    reverse: (seam: number) => `Turn seam ${seam} over and drape`,
    arrange: 'Arrange anew and drape',
    place: 'Place it by hand',
    sew: 'Look for its seams',
    edit: 'See its outline',
    seam: 'See the seam',
    time: (seconds: number) => `Give it ${seconds} s and drape`,
  },
  openSeams: (n: number) => n === 1 ? 'A seam stayed open' : `${number(n)} seams stayed open`,
  openings: (n: number) => n === 1 ? 'An opening is left' : `${number(n)} openings are left`,
  leftOut: (n: number) => n === 1 ? 'A piece was left out' : `${number(n)} pieces were left out`,
  without: (what: string) => `${what && `Since then: ${what} `}Cloth, figures and files here are those of before.`,
  texts: {
    inBody: 'The piece begins within the body. Arranged anew it stands clear of it.',
    inCloth: 'Two pieces begin within each other. Arranged anew they stand apart.',
    stalled: 'The seams could not be pulled shut. Nearer to each other, the pieces have less in their way.',
    project: 'The project itself is at fault, at the place named.',
    dxf: 'Export the DXF again from the pattern program, or correct the line named.',
    body: 'A body is one closed mesh of triangles. Another file, or a mannequin, can be chosen under Body.',
    seam: 'The seam joins what does not fit together: it may be turned over, or end elsewhere.',
    noSeams: 'Nothing says how its pieces are sewn. Seams can be looked for, or clicked together with N.',
    outline: 'The outline of the piece wants correcting.',
  },
};
