import { describe, expect, it } from 'vitest';
import { DrawPace } from '../src/scene/DrawPace';
import { kBodyOnly, poseFor, poseOf, kFov } from '../src/scene/framing';

/** `count` pictures, each asked for as the one before is drawn and drawn `ms` later; when the last was. */
function drawn(pace: DrawPace, count: number, ms: number, from = 0): number {
  let now = from;
  for (let i = 0; i < count; ++i) {
    pace.ask(now);
    now += ms;
    pace.draw(now);
  }
  return now;
}

describe('the pace of drawing', () => {
  it('stays sharp where pictures come swiftly', () => {
    const pace = new DrawPace();
    drawn(pace, 50, 16);
    expect(pace.sharpness).toBe(1);
  });

  it('grows coarser where they take long, to a bound, and sharp again where they no longer do', () => {
    const pace = new DrawPace();
    const now = drawn(pace, 30, 120);
    expect(pace.sharpness).toBe(0.6);
    expect(pace.restsAfter).toBeGreaterThan(200);
    drawn(pace, 60, 16, now);
    expect(pace.sharpness).toBe(1);
  });

  it('takes no pause for a slow picture: nothing was asked for meanwhile', () => {
    const pace = new DrawPace();
    let now = drawn(pace, 10, 16);
    for (let i = 0; i < 10; ++i) {
      pace.ask(now + 5000);
      now += 5016;
      pace.draw(now);
    }
    expect(pace.sharpness).toBe(1);
    expect(pace.restsAfter).toBe(250);
  });
});

describe('what a view shows', () => {
  const body: typeof kBodyOnly = { low: [-0.4, 0, -0.2], high: [0.4, 1.7, 0.2] };
  const skirt: typeof kBodyOnly = { low: [-0.2, 0.5, -0.2], high: [0.2, 1.0, 0.2] };
  const dress: typeof kBodyOnly = { low: [-0.3, 0.2, -0.2], high: [0.3, 1.45, 0.2] };

  it('is the cloth alone where it is short, with the body where it is tall, and all before a drape', () => {
    expect(poseOf('front', skirt, body, false, 1)).toEqual(poseFor('front', skirt, kFov, 1));
    expect(poseOf('front', dress, body, false, 1)).toEqual(poseFor('front', body, kFov, 1));
    expect(poseOf('front', skirt, body, true, 1)).toEqual(poseFor('front', body, kFov, 1));
  });

  it('is the body without cloth, and where a body would stand without either', () => {
    expect(poseOf('side', null, body, false, 1)).toEqual(poseFor('side', body, kFov, 1));
    expect(poseOf('side', null, null, false, 1)).toEqual(poseFor('side', kBodyOnly, kFov, 1));
  });
});
