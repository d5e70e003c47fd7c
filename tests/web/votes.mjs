// The votes of files of the lesson, as its page counts them.

import { countVotes } from "../../web/src/lesson/votes.ts";

const { files, edition, options } = JSON.parse(await new Response(process.stdin).text());
const predictions = new Map(Object.entries(options).map(([name, each]) => [name, { options: each }]));
const { counts, pupils, left } = countVotes(files, { edition, predictions });
const votes = Object.fromEntries([...counts].map(([name, each]) => [name, Object.fromEntries(each)]));
process.stdout.write(JSON.stringify({ votes, pupils, left }));
