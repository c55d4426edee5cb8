/** Scenes in Eric Haines' Neutral File Format (version 3.1 of its description), as in the Standard Procedural Databases. */
package enlightenment.nff;
