// @vitest-environment jsdom
import { fireEvent, screen, within } from '@testing-library/dom';
import { beforeEach, describe, expect, it } from 'vitest';
import { choose, click, openPage, type, type Page } from './page';
import type { Check, Finding } from '../../src/api/dressing';
import { ApiError } from '../../src/api/http';
import { ArrangePanel } from '../../src/panels/ArrangePanel';
import { BodyPanel } from '../../src/panels/BodyPanel';
import { ProblemList } from '../../src/panels/ProblemList';
import { ready } from '../../src/state/AppState';
import { squareOf } from '../fakes';
import { bodyOf, findingOf, meshFormats } from '../samples';

const button = (name: string | RegExp): HTMLElement => screen.getByRole('button', { name });
const refused = new ApiError(422, 'body.measure', 'the waist cannot be 12 cm', 'waist_cm');
const tables = {
  presets: [
    { name: 'eu38', sex: 'female' as const, measures_cm: { bust: 88, waist: 72, hip: 96 } },
    { name: 'm50', sex: 'male' as const, measures_cm: { bust: 100, waist: 88, hip: 101 } },
  ],
  formats: meshFormats,
  measures: [{ name: 'waist' as const, rule: 'narrowest', girth: true, least_cm: 30, most_cm: 250 }],
};

let page: Page;
beforeEach(() => {
  page = openPage();
});

describe('the body', () => {
  const open = (bodies = [bodyOf()]): void => {
    page.change((state) => {
      state.dressing.bodies.value = bodies;
      state.dressing.tables.value = tables;
    });
    page.show(<BodyPanel />);
    page.asked();
  };

  it('is waited for, and says why it does not come', () => {
    page.show(<BodyPanel />);
    expect(screen.getByRole('status').textContent).toContain('Measuring the body');
    page.change((state) => (state.dressing.problem.value = refused));
    expect(screen.getByRole('alert').textContent).toBe('The waist cannot be 12 cm.waist_cmbody.measure');
  });

  it('is nobody’s where no project is open', () => {
    page.change((state) => (state.route.value = { name: 'home' }));
    page.show(<BodyPanel />);
    expect(screen.getByText('Open a project to dress somebody.')).toBeTruthy();
  });

  it('gets another size of the table', () => {
    open();
    const size = screen.getByRole('combobox', { name: 'Size' });
    expect(within(size).getByRole('option', { name: 'EU 38 · 88-72-96' })).toBeTruthy();
    choose(size, 'm50');
    expect(page.asked()).toEqual([['dressing.choosePreset', 'm50']]);
  });

  it('gets a measure by its slider, or by a number in the unit that is chosen', () => {
    open();
    fireEvent.change(screen.getByRole('slider', { name: 'Waist' }), { target: { value: '75' } });
    click(screen.getByRole('radio', { name: 'in' }));
    page.change((state) => (state.dressing.unit.value = 'inch'));
    type(screen.getByRole('textbox', { name: 'Waist in' }), '30');
    expect(page.asked()).toEqual([
      ['dressing.setMeasure', 'waist', 75],
      ['dressing.takeUnit', 'inch'],
      ['dressing.setMeasure', 'waist', 76.2],
    ]);
  });

  it('is not of a size any more once a measure of it is its own', () => {
    open([bodyOf({ mannequin: { preset: 'eu38', waist_cm: 72 } })]);
    const size = screen.getByRole<HTMLSelectElement>('combobox', { name: 'Size' });
    expect(size.selectedOptions[0]?.textContent).toBe('EU 38 with own measures');
  });

  it('gives a measure of its own back to the table', () => {
    open();
    expect(button('Waist: follow from the table').hasAttribute('disabled')).toBe(true);
    open([bodyOf({ mannequin: { preset: 'eu38', waist_cm: 72 } })]);
    click(button('Waist: follow from the table'));
    expect(page.asked()).toEqual([['dressing.freeMeasure', 'waist']]);
  });

  it('lights the tape of the measure that is pointed at', () => {
    open();
    fireEvent.pointerEnter(screen.getByTitle('narrowest'));
    expect(page.asked()).toEqual([['dressing.light', 'waist']]);
  });

  it('stands as it is told, and shows what is switched on', () => {
    open();
    click(screen.getByRole('radio', { name: 'T' }));
    click(button('Landmarks'));
    type(screen.getByRole('textbox', { name: 'Skin offset mm' }), '2');
    expect(page.asked()).toEqual([
      ['dressing.setMannequin', { pose: 't' }],
      ['dressing.showMarks', { landmarks: true }],
      ['dressing.setSkinOffset', 2],
    ]);
  });

  it('has landmarks put back, and new ones placed by a click', () => {
    page.change((state) => (state.dressing.marks.value = { tape: false, landmarks: true, boxes: false }));
    open([bodyOf({ landmarks: [{ name: 'left_hip', place: [0, 1, 0], own: true }] })]);
    click(button('Put Left hip back'));
    expect(button('Place').hasAttribute('disabled')).toBe(true);
    fireEvent.input(screen.getByRole('textbox', { name: 'Name of a new landmark' }), { target: { value: 'belt' } });
    click(button('Place'));
    page.change((state) => (state.dressing.picking.value = 'belt'));
    expect(screen.getByRole('status').textContent).toBe('Click the body where belt is.');
    click(button('Cancel'));
    expect(page.asked()).toEqual([
      ['dressing.unmark', 'left_hip'],
      ['dressing.pick', 'belt'],
      ['dressing.pick', ''],
    ]);
  });

  it('may be a mesh of one’s own, which says how it was read', () => {
    open([bodyOf({ mannequin: null, file: 'scan.obj' })]);
    page.change(
      (state) =>
        (state.dressing.stance.value = {
          file: 'scan.obj',
          asset: 'a_1',
          stance: { unit_in_m: 0.01, up: 'z', upside_down: false, turned_degrees: 0 },
        }),
    );
    expect(screen.getByText(/Read as centimetres, z up\./)).toBeTruthy();
    expect(screen.getByText('72.0 cm')).toBeTruthy();
    expect(screen.queryByRole('slider')).toBeNull();
    click(button('Turn it round'));
    expect(page.asked()).toEqual([['dressing.dress', { asset: 'a_1', turn: 180 }, 'Turning the body']]);
  });

  it('takes every mesh that the service reads, in its place or beside it', () => {
    open();
    const [own, object] = ['Mesh of a body', 'Mesh of an object'].map((name) => screen.getByLabelText(name));
    expect((own as HTMLInputElement).accept).toBe('.obj,.stl,.ply,.gltf,.glb,.fbx,.dae,.3ds,.off');
    const file = new File(['x'], 'chair.off');
    for (const input of [own!, object!]) fireEvent.change(input, { target: { files: [file] } });
    expect(page.asked()).toEqual([
      ['dressing.takeFile', 'chair.off', file, false],
      ['dressing.takeFile', 'chair.off', file, true],
    ]);
  });

  it('is chosen among several, of which one may go', () => {
    open([bodyOf(), bodyOf({ id: 'chair', stands: false, mannequin: null, file: 'chair.obj', measures: [] })]);
    choose(screen.getByRole('combobox', { name: 'Body' }), '1');
    expect(screen.getByText(/chair\.obj is no standing person/)).toBeTruthy();
    click(button('Remove chair'));
    expect(page.asked()).toEqual([['dressing.undress']]);
  });
});

describe('the problems', () => {
  const open = (check: Check): void => {
    page.change((state) => (state.dressing.check.value = check));
    page.show(<ProblemList />);
  };
  const findings: Finding[] = [
    findingOf({ severity: 'note', message: 'a note' }),
    findingOf(),
    findingOf({ severity: 'error', message: 'it crosses' }),
    findingOf({ repaired: true, message: 'it was moved' }),
  ];

  it('are looked for', () => {
    page.show(<ProblemList />);
    expect(screen.getByRole('status').textContent).toContain('Looking at the start');
  });

  it('are none', () => {
    open({ ready: true, findings: [], pieces: [] });
    expect(screen.getByText('Ready to drape').parentElement!.textContent).toBe(
      'Ready to drapenothing to find fault with',
    );
  });

  it('stand with the worst first; what is only good to know is folded away', () => {
    open({ ready: false, findings, pieces: [] });
    expect(screen.getByText('1 error, 1 warning, 1 note, 1 repaired')).toBeTruthy();
    const rows = screen.getAllByRole('button', { name: /it |a note/i }).map((row) => row.textContent);
    expect(rows.slice(0, 2)).toEqual(['Error It crosses.piece front', 'Warning It touches.piece front']);
    expect(screen.getByText('2 things good to know')).toBeTruthy();
  });

  it('are flown to by a click', () => {
    open({ ready: false, findings, pieces: [] });
    click(button(/It crosses/));
    expect(page.asked()).toEqual([['dressing.look', findings[2]]]);
  });

  it('cannot be told where there is no start', () => {
    page.change((state) => (state.dressing.startProblem.value = refused));
    page.show(<ProblemList />);
    expect(screen.getByRole('alert').textContent).toBe('The waist cannot be 12 cm.waist_cm');
  });
});

describe('the places of the pieces', () => {
  const open = (check: Partial<Check> = {}): void => {
    page.change((state) => {
      state.pieces.value = ready({ pieces: [squareOf('front', 0, 0, 10), squareOf('back', 0, 0, 10)], seams: [] });
      state.dressing.check.value = { ready: true, findings: [], pieces: [], ...check };
    });
    page.show(<ArrangePanel />);
  };

  it('belong to a project', () => {
    page.change((state) => (state.route.value = { name: 'home' }));
    page.show(<ArrangePanel />);
    expect(screen.getByText('Open a project to arrange its pieces.')).toBeTruthy();
  });

  it('are found with one click, unless something is under way', () => {
    open();
    click(button('Arrange the pieces'));
    click(button('Boxes'));
    expect(page.asked()).toEqual([['dressing.arrange'], ['dressing.showMarks', { boxes: true }]]);
    page.change((state) => (state.dressing.busy.value = 'Arranging the pieces'));
    expect(button('Arrange the pieces').hasAttribute('disabled')).toBe(true);
  });

  it('are told beside each piece: by hand, or as they were made', () => {
    const by_hand = { part: 'left_arm', side: 'front', at_mm: [0, 0], away_mm: 50, turn: 0, wrapped: false, flipped: false } as const;
    const hand = { ...by_hand, at_mm: [0, 0] as [number, number] };
    page.change(
      (state) =>
        (state.dressing.arrangement.value = {
          pieces: [{ id: 'back', place: 'torso, back' }],
          holds: [],
          findings: [],
        }),
    );
    open({ pieces: [{ id: 'front', low: [0, 0, 0], high: [0, 0, 0], by_hand: hand, stands: hand }] });
    expect(button(/^front/).textContent).toBe('frontby hand: left arm, front');
    expect(button(/^back/).textContent).toBe('backtorso, back');
    click(button(/^back/));
    expect(page.asked()).toEqual([['select', 'back']]);
  });

  it('are shown as the arrangement made them, and are gone on from', () => {
    const stands = {
      part: 'left_arm' as const,
      side: 'left' as const,
      at_mm: [4, -30] as [number, number],
      away_mm: 20,
      turn: 12,
      wrapped: true,
      flipped: false,
    };
    open({ pieces: [{ id: 'front', low: [0, 0, 0], high: [0, 0, 0], by_hand: null, stands }] });
    page.change((state) => (state.selected.value = 'front'));
    expect(screen.getByRole('combobox', { name: 'Part' })).toHaveProperty('value', 'left_arm');
    expect(screen.getByRole('checkbox', { name: 'Rolled around the part' })).toHaveProperty('checked', true);
    type(screen.getByRole('textbox', { name: 'Away mm' }), '35');
    click(button('Turn the piece over'));
    expect(page.asked()).toEqual([
      ['dressing.place', { ...stands, piece: 'front', away_mm: 35 }],
      ['dressing.place', { ...stands, piece: 'front', flipped: true }],
    ]);
  });

  it('are changed by hand, and every change is sent', () => {
    open();
    page.change((state) => (state.selected.value = 'front'));
    choose(screen.getByRole('combobox', { name: 'Part' }), 'hips');
    click(screen.getByRole('radio', { name: 'Left' }));
    type(screen.getByRole('textbox', { name: 'Up mm' }), '30');
    click(screen.getByRole('checkbox', { name: 'Rolled around the part' }));
    const first = { part: 'torso', side: 'front', at_mm: [0, 0], away_mm: 50, turn: 0, wrapped: false, flipped: false };
    expect(page.asked()).toEqual(
      [{ part: 'hips' }, { side: 'left' }, { at_mm: [0, 30] }, { wrapped: true }].map((change) => [
        'dressing.place',
        { ...first, piece: 'front', ...change },
      ]),
    );
  });

  it('take the mirror image along, or not', () => {
    open();
    click(screen.getByRole('checkbox', { name: 'The mirror image goes along on the other side' }));
    expect(page.state.dressing.partners.value).toBe(false);
  });

  it('say why a wish was refused', () => {
    open();
    page.change((state) => (state.dressing.placeProblem.value = refused));
    expect(screen.getByRole('alert').textContent).toContain('The waist cannot be 12 cm.');
  });
});
