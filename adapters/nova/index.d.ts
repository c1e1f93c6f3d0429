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
     */
    exchange(options: NovaOptions): void;
    /**
     * Sets the traits of a breed, by its name, or of an agent, in place of what was set for it before. An agent's count before its breed's.
     *
     * @param whose a breed's name, or an agent
     * @param traits null for none
     * @throws RangeError if they cannot be; nothing is then changed
     */
    setTraits(whose: string | NovaAgent, traits: NovaTraits | null): void;
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
 */
export function installInto(window: object, options?: NovaOptions): NovaInstallation;
