// What the compiler does not look at: short functions, one statement a line, promises that nobody waits for, the order
// of hooks. Run from the folder above, so that the codec of proto/ts keeps to the same rules.

import stylistic from '@stylistic/eslint-plugin';
import hooks from 'eslint-plugin-react-hooks';
import tseslint from 'typescript-eslint';

/** Statements that begin with a condition or a range and may have their one statement on the same line. */
const heads = ['IfStatement', 'ForStatement', 'ForInStatement', 'ForOfStatement', 'WhileStatement'];

const shape = {
  'max-lines-per-function': ['error', { max: 60, skipBlankLines: true, skipComments: true, IIFEs: true }],
  // Each ?., ?? and && of a panel's markup counts as a branch, so this is no more than a handful of real ones.
  complexity: ['error', { max: 12 }],
  'no-sequences': ['error', { allowInParentheses: false }],
  'no-multi-assign': 'error',
  'one-var': ['error', 'never'],
  '@stylistic/max-statements-per-line': ['error', { max: 1, ignoredNodes: heads }],
};

const hookRules = {
  'react-hooks/rules-of-hooks': 'error',
  'react-hooks/exhaustive-deps': 'error',
};

const types = {
  // A name that begins with an underscore is there to be left out: of an object, of a list of arguments.
  // Props are written as methods and taken apart: their functions need no this.
  '@typescript-eslint/unbound-method': 'off',
  '@typescript-eslint/no-unused-vars': [
    'error',
    { argsIgnorePattern: '^_', varsIgnorePattern: '^_', destructuredArrayIgnorePattern: '^_' },
  ],
};

export default tseslint.config(
  { ignores: ['**/dist/**', '**/node_modules/**', '**/generated/**'] },
  { linterOptions: { reportUnusedDisableDirectives: 'error' } },
  ...tseslint.configs.recommendedTypeChecked,
  {
    languageOptions: { parserOptions: { project: 'tsconfig.json', tsconfigRootDir: import.meta.dirname } },
    plugins: { '@stylistic': stylistic, 'react-hooks': hooks },
    rules: { ...shape, ...hookRules, ...types },
  },
  {
    // The compiler does not read the mock: it needs Node's types, and the page must not have them.
    files: ['**/mock/**'],
    ...tseslint.configs.disableTypeChecked,
  },
  {
    files: ['**/*.test.ts', '**/*.test.tsx', '**/*.bench.ts', '**/test/**'],
    rules: {
      // A describe is a list of tests, not a function that somebody has to follow.
      'max-lines-per-function': 'off',
      // Stand-ins answer at once where the service takes its time.
      '@typescript-eslint/require-await': 'off',
    },
  },
);
