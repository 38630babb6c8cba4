import { ApiError } from '../api/http';
import type { AppState, Notice } from '../state/AppState';

const kShownMs = 6000;
let lastId = 0;

/** Shows a line at the edge of the page. Bad news stays until it is put away. */
export function notify(state: AppState, notice: Omit<Notice, 'id'>): void {
  const id = ++lastId;
  state.notices.value = [...state.notices.value.slice(-3), { ...notice, id }];
  if (notice.tone !== 'bad') setTimeout(() => dismiss(state, id), kShownMs);
}

export function dismiss(state: AppState, id: number): void {
  state.notices.value = state.notices.value.filter((notice) => notice.id !== id);
}

/** Any thrown thing as the error that is shown. */
export function asApiError(error: unknown): ApiError {
  if (error instanceof ApiError) return error;
  return new ApiError(0, 'page.unexpected', error instanceof Error ? error.message : String(error));
}

export function notifyError(state: AppState, error: unknown): void {
  const { detail, code, where } = asApiError(error);
  notify(state, { tone: 'bad', text: detail, code, where });
}
