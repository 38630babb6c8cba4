// Finds texts that stand inline in a source of the page: what a person reads belongs into src/texts. It reads the source
// with the compiler's own parser, so that comments, imports and types are none.

import ts from 'typescript';

/** Names of things that are called so in every language, and addresses. */
const kNames = new Set(['Toile', 'DXF', './run', 'Letter', 'PDF', 'SVG', 'PNG', 'MP4', 'Kim and Park 2003', 'Files', 'toile_…']);
/** Words of the service that are looked for in what it says. */
const kServices = new Set(['open seam', 'open button']);
/** Of KeyboardEvent.key, and as keys.ts names them to look up what a keyboard has on them. */
const kKeys = /^((Ctrl |Shift )*\w|Arrow(Left|Right|Up|Down)|Enter|Escape|Space|Del|Esc)$/;
/** Headers and media queries. */
const kTechnical = /^(Content-Type|If-Match|Idempotency-Key|\(prefers-[a-z-]+: [a-z]+\))$/;

/** What an element says: any letter there is a text. */
const kSaying = new Set(['title', 'placeholder', 'alt', 'label', 'text', 'aria-label', 'aria-valuetext', 'aria-description']);
/** What an element is. */
const kBeing = /^(class|style|type|role|id|key|d|name|href|rel|for|autocomplete|transform|path|viewBox|fill|tabbed|data-.*|aria-(controls|labelledby|live|orientation|haspopup))$/;

const words = (text: string): boolean => /\p{L}{2}/u.test(text);
/** Two words with a space between, or one that begins like a sentence. */
const reads = (text: string): boolean => /\p{L}{2,}[,:;.…]? \p{L}{2,}/u.test(text) || /^\s*\p{Lu}\p{Ll}+/u.test(text);
const known = (text: string): boolean => kNames.has(text) || kServices.has(text) || kKeys.test(text) || kTechnical.test(text);

const attributeOf = (node: ts.Node): string => {
  for (let at: ts.Node = node; at.parent !== undefined; at = at.parent) {
    if (ts.isJsxAttribute(at)) return at.name.getText();
    if (ts.isJsxElement(at) || ts.isFunctionLike(at)) return '';
  }
  return '';
};

/** What a program says to a programmer, and what it compares and looks up. */
function isTechnical(node: ts.Node): boolean {
  const { parent } = node;
  if (ts.isNewExpression(parent)) return /Error$/.test(parent.expression.getText());
  if (ts.isCallExpression(parent)) return /\.(closest|matches|querySelector(All)?|startsWith|endsWith)$|^matchMedia$/.test(parent.expression.getText());
  if (ts.isElementAccessExpression(parent)) return true;
  return ts.isBinaryExpression(parent) && /^[=!]==$/.test(parent.operatorToken.getText());
}

function textOf(node: ts.Node): string | null {
  if (ts.isJsxText(node)) return node.text.replace(/\s+/g, ' ').trim();
  if (ts.isStringLiteral(node) || ts.isNoSubstitutionTemplateLiteral(node)) return node.text;
  if (ts.isTemplateExpression(node)) return [node.head, ...node.templateSpans.map((span) => span.literal)].map((part) => part.text).join('…');
  return null;
}

function isText(node: ts.Node, text: string): boolean {
  if (ts.isJsxText(node)) return words(text) && !known(text);
  const attribute = attributeOf(node);
  if (kBeing.test(attribute) || known(text.trim()) || isTechnical(node)) return false;
  return kSaying.has(attribute) ? words(text) && text !== 'x' && text !== 'y' : reads(text);
}

/** Whether `t` is read when the module is loaded: then it speaks English for ever. */
function isFrozen(node: ts.Node): boolean {
  if (!ts.isPropertyAccessExpression(node) || node.expression.getText() !== 't') return false;
  for (let at: ts.Node = node; at.parent !== undefined; at = at.parent) if (ts.isFunctionLike(at)) return false;
  return true;
}

/** "12: Save as JSON" for each text that stands inline. */
export function literalsOf(name: string, source: string): string[] {
  const kind = name.endsWith('x') ? ts.ScriptKind.TSX : ts.ScriptKind.TS;
  const file = ts.createSourceFile(name, source, ts.ScriptTarget.Latest, true, kind);
  const found: string[] = [];
  const look = (node: ts.Node): void => {
    if (ts.isImportDeclaration(node) || ts.isExportDeclaration(node) || ts.isTypeNode(node)) return;
    const text = textOf(node);
    const line = file.getLineAndCharacterOfPosition(node.getStart()).line + 1;
    if (text !== null && isText(node, text)) found.push(`${line}: ${text}`);
    if (isFrozen(node)) found.push(`${line}: ${node.getText()} is read before a language is spoken`);
    node.forEachChild(look);
  };
  look(file);
  return found;
}
