package growth
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;

    /** A frame of agents, and handlers. */
    public final class AgentRows
    {
        /** All rows. */
        public static function get all():Array
        {
            return [
                    new GrowthRow("agents: handlers of breeds", "breeds", 25, 4000, beginHandlers),
                    new GrowthRow("agents: models", "models", 25, 4000, beginModels),
                    new GrowthRow("agents: points among spheres", "agents", 100, 40000, beginPoints),
                    new GrowthRow("agents: sizes over many orders", "agents", 100, 40000, beginSizes),
                    new GrowthRow("agents: hierarchies of rows", "vertices", 200, 40000, beginHierarchies)];
        }

        // A handler for each breed, and one frame with an agent of each.
        private static function beginHandlers(n:int, row:GrowthRow):Function
        {
            var greatLand:GreatLand = land();
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < n; i++)
            {
                agents.push(agentAt("ball", "growth" + i, 2 * i, 0));
            }
            return function():Object
            {
                var collision:Collision = new Collision(new BinCollider(greatLand));
                for (var k:int = 1; k < n; k++)
                {
                    collision.onCollision("growth" + (k - 1), "growth" + k, pass);
                }
                collision.update(agents);
                return collision;
            };
        }

        private static function beginModels(n:int, row:GrowthRow):Function
        {
            var greatLand:GreatLand = new GreatLand();
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < n; i++)
            {
                greatLand.addModel(new Model("m" + i, new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]));
                agents.push(agentAt("m" + i, "turtles", 2 * i, 0));
            }
            return beginFrame(new TightestFitCollider(greatLand), agents);
        }

        private static function beginPoints(n:int, row:GrowthRow):Function
        {
            var greatLand:GreatLand = land();
            greatLand.addModel(new Model("dot", new <Number>[0, 0, 0]));
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var side:int = Math.ceil(Math.sqrt(n));
            for (var i:int = 0; i < n; i++)
            {
                agents.push(agentAt((i & 1) == 0 ? "ball" : "dot", "turtles", 1.5 * (i % side), 1.5 * int(i / side)));
            }
            return beginFrame(new TightestFitCollider(greatLand), agents);
        }

        // Sizes from 1e-6 to 1e4, each far from the others.
        private static function beginSizes(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < n; i++)
            {
                var size:Number = Math.pow(10, i % 11 - 6);
                var agent:Agent = agentAt("ball", "turtles", 3 * size * int(i / 11), 3 * size);
                agent.size = size;
                agents.push(agent);
            }
            return beginFrame(new BinCollider(land()), agents);
        }

        // The distance from a vertex to the next grows by a factor, so the mean cuts few vertices off.
        private static function beginHierarchies(n:int, row:GrowthRow):Function
        {
            var points:Vector.<Number> = new Vector.<Number>();
            var x:Number = 1;
            for (var i:int = 0; i < n; i++)
            {
                x *= 1 + 600 / n;
                points.push(x, 0, 0);
            }
            var model:Model = new Model("row", points);
            return function():Object
            {
                var greatLand:GreatLand = new GreatLand();
                greatLand.hierarchies.splitByMean = true;
                greatLand.addModel(model);
                var agents:Vector.<Agent> = new <Agent>[agentAt("row", "turtles", 0, 0), agentAt("row", "turtles", 0.5, 0)];
                return new HierarchicalCollider(greatLand).findCollisions(agents);
            };
        }

        private static function beginFrame(system:CollisionSystem, agents:Vector.<Agent>):Function
        {
            return function():Object
            {
                return system.findCollisions(agents);
            };
        }

        private static function land():GreatLand
        {
            var greatLand:GreatLand = new GreatLand();
            var ball:Model = BuiltInModel.sphere();
            greatLand.addModel(new Model("ball", ball.vertices, ball.triangles));
            return greatLand;
        }

        private static function agentAt(shape:String, breed:String, x:Number, y:Number):Agent
        {
            var agent:Agent = new Agent(shape, breed);
            agent.moveTo(x, y, 0);
            return agent;
        }

        private static function pass(collider:Agent, collidee:Agent):void
        {
            collider.color = collidee.color;
        }
    }
}
