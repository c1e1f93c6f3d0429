/**
 * What the engine answers, walks and builds for blocks. The world is drawn without it; it is loaded with the blocks, before a game runs. A
 * game that needs it already at its beginning is drawn then.
 */
import { AgentQueries, ContactBlocks, DetectionBlocks, Terrain, TerrainBlocks, WalkBlocks, WorldBounds } from "starlogo-collision";
import { World } from "./world.js";

World.engine = { AgentQueries, ContactBlocks, DetectionBlocks, Terrain, TerrainBlocks, WalkBlocks, WorldBounds };
