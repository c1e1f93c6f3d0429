package support
{
    import evaluation.pairs.SeededRandom;
    import starlogo.agents.Agent;

    /** Changes of agents at random. */
    public final class AgentChanges
    {
        /**
         * Changes a trait.
         *
         * @param trait "position", "jump", "unknown shape", or the name of the property
         * @param shapes the shapes that agents have
         */
        public static function change(trait:String, agent:Agent, shapes:Array, random:SeededRandom):void
        {
            switch (trait)
            {
                case "position":
                    agent.moveTo(agent.x + random.normal(), agent.y + random.normal(), agent.z + 0.3 * random.normal());
                    break;
                case "jump":
                    agent.jumpTo(agent.x + random.normal(), agent.y + random.normal(), agent.z + 0.3 * random.normal());
                    break;
                case "size":
                    agent.size *= random.pick([0.4, 0.8, 1.5]);
                    break;
                case "shape":
                    agent.shape = shapes[(shapes.indexOf(agent.shape) + random.integer(1, shapes.length - 1)) % shapes.length];
                    break;
                case "unknown shape":
                    agent.shape = "nothing";
                    break;
                case "hierarchical":
                    agent.hierarchical = !agent.hierarchical;
                    break;
                case "collideAs":
                    agent.collideAs = random.pick([Agent.SPHERE, Agent.BOX, Agent.CAPSULE, Agent.HULL]);
                    break;
                case "traversalDepth":
                    agent.traversalDepth = agent.traversalDepth == 1 ? 6 : 1;
                    break;
                case "sweeps":
                    agent.sweeps = !agent.sweeps;
                    break;
                case "breed":
                    agent.breed = "others";
                    break;
                default:
                    // heading, pitch, roll
                    agent[trait] = random.between(0, 360);
            }
        }
    }
}
