/** The sign of the house, without its name's link. */
export function BrandMark() {
  return (
    <>
      <svg viewBox="0 0 32 32" width="22" height="22" aria-hidden="true">
        <rect width="32" height="32" rx="7" />
        <path d="M11 7h10l1.2 3.6H9.8z" />
        <path d="M9.4 12h13.2l4 12.4c-3.2 1.5-5.8-.6-8.4.3-2.7.9-4.9 1.1-7.3.2-1.9-.7-3.7.4-5.5-.5z" opacity=".82" />
      </svg>
      <span>Toile</span>
    </>
  );
}
