import type { GreatLand, Model } from "starlogo-collision";

/** What decides what collides, as in the engine's own colliders. */
export type NovaSystem = "bins" | "tightest" | "hierarchical" | "combination";

/** Traits that the client has no blocks for. Those that are left out are as if nothing had been said. */
export interface NovaTraits {
    /** For "combination": a tree of boxes in place of the tightest structure. */
    hierarchical?: boolean;
    /** How many levels of its tree are looked at; 0 for as many as the options say. */
    depth?: number;
    /** Whether its whole way from one tick to the next collides. */
    sweeps?: boolean;
    /** What it is when it is no tree. */
    structure?: "tightest" | "sphere" | "box" | "capsule";
}

/** How the engine takes the place of the client's collisions. */
export interface NovaOptions {
    /**
     * "bins", unless told: the client's own rule. Two agents collide that are nearer than half the sum of their sizes; a size of 0 is a point.
     * The others: what is drawn collides, and touching is colliding; a size of 0 takes no part.
     */
    system?: NovaSystem;
    /** For "hierarchical" and "combination": triangles decide. */
    exact?: boolean;
    /** For "hierarchical" and "combination": how many levels of a tree are looked at; 5 unless told. */
    depth?: number;
    /** Whether all agents sweep for which the traits do not say otherwise. */
    sweeps?: boolean;
    /** Traits by the name of a breed. */
    breeds?: Record<string, NovaTraits>;
    /**
     * Models in place of those of the client, by the shape of an agent: a model, an address, or null for the sphere; undefined for the
     * client's. Read when it is installed.
     */
    shapes?: Record<string, Model | string | null> | ((shape: string) => Model | string | null | undefined);
    /**
     * Whether a wireframe of what collides is shown in the client's view: spheres, tightest fits, the boxes of the deepest level that is looked
     * at, triangles; red what the last tick found to collide. In three dimensions it goes the way that the client draws between two ticks.
     */
    overlay?: boolean;
    /** Where the list is of what `starlogo-bake --scaling volume --transforms` has made of models. Read when it is installed. */
    manifest?: string | null;
}

/** An agent of the client; the engine reads more of it than is named here. */
export interface NovaAgent {
    readonly id: number;
}

/** What is installed in a client. */
export interface NovaInstallation {
    /** Whether it still is. */
    readonly isInstalled: boolean;
    /** What counts, with what was left out. */
    readonly options: NovaOptions;
    /** The models, by the client's shapes. */
    readonly greatLand: GreatLand;
    /** How many models are not loaded yet; their agents are spheres that stand on their places until then. */
    readonly pendingCount: number;
    /** What could not be loaded, and why. */
    readonly problems: readonly string[];
    /**
     * Goes on with other options from the next tick on; those that are not named stay.
     *
     * @throws RangeError if they cannot be; nothing is then changed
     * @throws TypeError if there is to be an overlay, and no view that it can be in
     */
    exchange(options: NovaOptions): void;
    /** Shows what collides in the client's view, or ceases to, as the option `overlay`. */
    showOverlay(isOn?: boolean): void;
    /**
     * Sets the traits of a breed, by its name, or of an agent, in place of what was set for it before. An agent's count before its breed's.
     *
     * @param whose a breed's name, or an agent
     * @param traits null for none
     * @throws RangeError if they cannot be; nothing is then changed
     */
    setTraits(whose: string | NovaAgent, traits: NovaTraits | null): void;
    /**
     * Sets some of an agent's traits, as its blocks do; the others that were set for it stay. Agents that it makes of its breed have them too.
     *
     * @throws RangeError if they cannot be; nothing is then changed
     */
    changeTraits(agent: NovaAgent, traits: NovaTraits): void;
    /** Whether two agents touch, as the last getCollisions saw them; whether their breeds have blocks does not matter. */
    areColliding(a: NovaAgent, b: NovaAgent): boolean;
    /** Gives the client its own collisions back, with all agents in its bins. Does nothing the second time. */
    uninstall(): void;
}

/**
 * Puts the engine in the place of the collisions of the StarLogo Nova client that runs in a window. What was installed there before is
 * uninstalled. It may be done at any time, also while a project runs.
 *
 * @param window which has the client's Execution and Common
 * @param options what collides
 * @throws TypeError if no client is in the window
 * @throws RangeError if the options cannot be; what was installed then stays
 * @throws TypeError if there is to be an overlay, and no view that it can be in; what was installed then stays
 */
export function installInto(window: object, options?: NovaOptions): NovaInstallation;

/**
 * Puts a button into the client's toolbar, whose menu chooses what decides collisions and whether it is shown. Nothing is installed until
 * something is chosen.
 *
 * @param window which has the client, and its page
 * @param options for what is then installed, the system left out
 * @throws TypeError if no client with a toolbar is in the window
 */
export function addButton(window: object, options?: NovaOptions): {
    /** Takes the button away; what is installed stays. */
    remove(): void;
};

/**
 * Puts blocks for traits into the drawer of the client's editor that has its block for collisions: hierarchical, depth, sweeping, structure.
 * An agent's program sets its own. They do nothing while nothing is installed. A project that has them is compiled only where they are known.
 *
 * @throws TypeError if the window has no such editor
 */
export function addBlocks(window: object): {
    /** Takes them out of the drawer; those in programs stay. */
    remove(): void;
};

/**
 * For a bookmarklet: installs the engine, unless it is, and adds the button and, where there is an editor, the blocks. The next time takes all
 * of that away.
 *
 * @throws TypeError if no client with a toolbar is in the window
 */
export function toggle(window: object, options?: NovaOptions): void;
