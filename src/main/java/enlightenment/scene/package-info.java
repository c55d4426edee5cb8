/** Scenes as plain, immutable data, and the settings that they are rendered with. */
package enlightenment.scene;
