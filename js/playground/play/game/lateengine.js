/** Provides the part of the engine that late.js tells of. */
import { AgentQueries, ContactBlocks, DetectionBlocks, Terrain, TerrainBlocks, WalkBlocks, WorldBounds } from "starlogo-collision";
import { provideLateEngine } from "./late.js";

provideLateEngine({ AgentQueries, ContactBlocks, DetectionBlocks, Terrain, TerrainBlocks, WalkBlocks, WorldBounds });
