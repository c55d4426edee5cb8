/** What a render is, told in a few bytes that are the same wherever it is asked: scene, image files, settings, version. */
package enlightenment.job;
