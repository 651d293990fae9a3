/** Names of the report's task phases 1 to 4: as orders, and as activities. */

export const TASKS = ['Acquire', 'Extract', 'Manoeuvre', 'Docked'] as const;
export const ACTIVITIES = ['acquisition', 'extraction', 'manoeuvring', 'docked'] as const;
