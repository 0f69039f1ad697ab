import js from "@eslint/js";

export default [
  js.configs.recommended,
  {
    rules: {
      // Python's None may arrive as undefined: == null is right for both, === null is not.
      eqeqeq: ["error", "always", { null: "never" }],
      "max-len": ["error", { code: 100 }],
      "no-undef": "off",                            // TypeScript finds these, and knows browsers
      "no-var": "error",
      "prefer-const": "error",
    },
  },
];
