// The tour for somebody who has just come.

export const tour = {
  title: 'Tour of the page',
  count: (n: number, of: number) => `${n} of ${of}`,
  skip: 'Skip',
  back: 'Back',
  next: 'Next',
  done: 'Done',
  again: 'Take the tour',
  stops: {
    cloth: {
      title: 'The garment on a body',
      text: 'Drag to turn the view, the wheel comes nearer. The buttons above show it from each side, and colour the cloth by how far it is stretched or stands off the body.',
    },
    pattern: {
      title: 'Its flat pieces',
      text: 'Select a piece and it is lit on the body too. With the tools above you move points and sew edges together; each seam has its own colour. Ctrl Z takes back what you did.',
    },
    body: {
      title: 'Body and places',
      text: 'Body has sizes and measures, or takes your own mesh. Arrange stands the pieces around it with one click and lists what keeps a drape from beginning.',
    },
    drape: {
      title: 'Drape it',
      text: 'Space starts, pauses and goes on. You may edit the pattern while the cloth falls, or close the page: the drape goes on without it.',
    },
    result: {
      title: 'What came of it',
      text: 'Result, once a drape has ended, tells how the garment fits and has pictures, movies and models to take home. Press ? for all keys, and for this tour.',
    },
  },
};
