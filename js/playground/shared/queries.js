/** The engine's questions, for what loads them later. */
import { AgentQueries } from "starlogo-collision";

export { AgentQueries };
