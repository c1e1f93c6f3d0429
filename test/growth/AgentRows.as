package growth
{
    import evaluation.pairs.SeededRandom;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.diagnostics.CollisionRecorder;
    import starlogo.models.Model;
    import starlogo.terrain.WorldBounds;
    import support.agentAt;

    /** A frame of agents, and handlers. */
    public final class AgentRows
    {
        /** All rows. */
        public static function get all():Array
        {
            return [
                    new GrowthRow("agents: handlers of breeds", "breeds", 25, 64000, beginHandlers(addNeighbours)),
                    new GrowthRow("agents: handlers of one breed and each other", "breeds", 25, 64000, beginHandlers(addOfOne)),
                    new GrowthRow("agents: handlers of each breed and any", "breeds", 25, 64000, beginHandlers(addAny)),
                    new GrowthRow("agents: handlers of breeds added and taken out", "breeds", 25, 8000, beginRemoved),
                    new GrowthRow("agents: handlers of one pair, the first one removed first", "handlers", 100, 200000, beginOnePair(false)),
                    new GrowthRow("agents: handlers of one pair, the last one removed first", "handlers", 100, 8000, beginOnePair(true)).admitted(),
                    new GrowthRow("agents: a handler of a pair added and removed again", "times", 100, 200000, beginAgain),
                    new GrowthRow("agents: collisions of many breeds, recorded", "breeds", 25, 64000, beginRecorded),
                    new GrowthRow("agents: models", "models", 25, 16000, beginModels),
                    new GrowthRow("agents: a frame", "agents", 100, 200000, beginMoving("ball", false, false)),
                    new GrowthRow("agents: a frame of trees and triangles", "agents", 25, 40000, beginMoving("cube", false, true)),
                    new GrowthRow("agents: a frame of sweeps", "agents", 100, 200000, beginMoving("ball", true, false)),
                    new GrowthRow("agents: a frame at the edges", "agents", 100, 200000, beginEdges),
                    new GrowthRow("agents: points among spheres", "agents", 100, 200000, beginPoints),
                    new GrowthRow("agents: sizes over many orders", "agents", 100, 200000, beginSizes),
                    new GrowthRow("agents: sizes over many orders, moving", "agents", 100, 200000, beginMovingSizes),
                    new GrowthRow("agents: sizes over twelve orders, apart", "agents", 100, 200000, beginApart),
                    new GrowthRow("agents: one huge, far above", "agents", 100, 200000, beginFarAbove),
                    new GrowthRow("agents: one very large, one very long", "agents", 100, 200000, beginLarge),
                    new GrowthRow("agents: rows of agents over many orders of distance", "agents", 100, 200000, beginFarApart),
                    new GrowthRow("agents: all leave and others come", "agents", 100, 200000, beginChanging),
                    new GrowthRow("agents: snapshots", "agents", 100, 200000, beginSnapshots),
                    new GrowthRow("agents: hierarchies of rows", "vertices", 200, 40000, beginHierarchies)];
        }

        // An agent of each breed. The agent of the first breed is near all others on the ground.
        private static function agentsOfBreeds(n:int):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < n; i++)
            {
                agents.push(agentAt("ball", 2 * i, 0, 0, "growth" + i));
            }
            agents[0].size = 4 * n;
            return agents;
        }

        // The agent of the first breed touches all others.
        private static function beginRecorded(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = agentsOfBreeds(n);
            agents[0].z = -2 * n;
            return function():Object
            {
                var recorder:CollisionRecorder = new CollisionRecorder(new BinCollider());
                recorder.findCollisions(agents);
                return recorder;
            };
        }

        // A handler for each breed, and one frame with an agent of each.
        private static function beginHandlers(add:Function):Function
        {
            return function(n:int, row:GrowthRow):Function
            {
                var greatLand:GreatLand = GrowthGame.land();
                var agents:Vector.<Agent> = agentsOfBreeds(n);
                return function():Object
                {
                    var collision:Collision = new Collision(new BinCollider(greatLand));
                    for (var k:int = 1; k < n; k++)
                    {
                        add(collision, k);
                    }
                    collision.update(agents);
                    return collision;
                };
            };
        }

        private static function addNeighbours(collision:Collision, k:int):void
        {
            collision.onCollision("growth" + (k - 1), "growth" + k, pass);
        }

        private static function addOfOne(collision:Collision, k:int):void
        {
            collision.onCollision("growth0", "growth" + k, pass);
        }

        private static function addAny(collision:Collision, k:int):void
        {
            collision.onCollision("growth" + k, Collision.ANY_BREED, pass);
        }

        // All handlers are there at once, and then none is.
        private static function beginRemoved(n:int, row:GrowthRow):Function
        {
            return function():Object
            {
                var collision:Collision = new Collision(new BinCollider(new GreatLand()));
                for (var k:int = 1; k < n; k++)
                {
                    collision.onCollisionStart("growth" + (k - 1), Collision.ANY_BREED, pass);
                    collision.onCollision("growth" + (k - 1), "growth" + k, pass);
                }
                for (k = 1; k < n; k++)
                {
                    collision.removeHandler("growth" + (k - 1), "growth" + k, pass);
                    collision.removeHandler("growth" + (k - 1), Collision.ANY_BREED, pass);
                }
                return collision;
            };
        }

        // Handlers of one pair of breeds, each with a function of its own.
        private static function beginOnePair(isLastFirst:Boolean):Function
        {
            return function(n:int, row:GrowthRow):Function
            {
                var handlers:Array = [];
                for (var i:int = 0; i < n; i++)
                {
                    handlers.push(newHandler());
                }
                return function():Object
                {
                    var collision:Collision = new Collision(new BinCollider(new GreatLand()));
                    for (var k:int = 0; k < n; k++)
                    {
                        collision.onCollision("sheep", "wolves", handlers[k]);
                    }
                    for (k = 0; k < n; k++)
                    {
                        collision.removeHandler("sheep", "wolves", handlers[isLastFirst ? n - 1 - k : k]);
                    }
                    return collision;
                };
            };
        }

        private static function newHandler():Function
        {
            return function(collider:Agent, collidee:Agent):void
            {
                collider.color = collidee.color;
            };
        }

        private static function beginAgain(n:int, row:GrowthRow):Function
        {
            return function():Object
            {
                var collision:Collision = new Collision(new BinCollider(new GreatLand()));
                for (var k:int = 0; k < n; k++)
                {
                    collision.onCollision("sheep", "wolves", pass);
                    collision.removeHandler("sheep", "wolves", pass);
                }
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
                agents.push(agentAt("m" + i, 2 * i, 0, 0));
            }
            return beginFrame(new TightestFitCollider(greatLand), agents);
        }

        // A frame with handlers of starts, contacts and ends, after all agents have moved. A third of them touch.
        private static function beginMoving(shape:String, areSweeping:Boolean, areTrees:Boolean):Function
        {
            return function(n:int, row:GrowthRow):Function
            {
                var agents:Vector.<Agent> = GrowthGame.square(n, shape, 1.5);
                for (var i:int = 0; i < n; i++)
                {
                    agents[i].moveTo(agents[i].x + (i % 3 == 0 ? 0.6 : 0), agents[i].y, 0);
                    agents[i].sweeps = areSweeping;
                    agents[i].hierarchical = areTrees;
                }
                var collider:CombinationCollider = new CombinationCollider(GrowthGame.land(areTrees));
                collider.exact = areTrees;
                return moving(new Collision(collider), agents, 0.01);
            };
        }

        private static function beginEdges(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "cube", 1.5);
            var collision:Collision = new Collision(new TightestFitCollider(GrowthGame.land()));
            collision.bounds = new WorldBounds(1, 1, -Infinity, 1.5 * Math.sqrt(n) - 3, Infinity, Infinity);
            collision.onCollision(Collision.EDGE, "turtles", keep);
            return moving(collision, agents, 0.01);
        }

        private static function moving(collision:Collision, agents:Vector.<Agent>, by:Number):Function
        {
            collision.onCollisionStart("turtles", "turtles", pass);
            collision.onCollision("turtles", "turtles", keep);
            collision.onCollisionEnd("turtles", "turtles", pass);
            return function():Object
            {
                for each (var agent:Agent in agents)
                {
                    agent.moveTo(agent.x + by * agent.size, agent.y, agent.z);
                }
                collision.update(agents);
                return collision;
            };
        }

        private static function beginPoints(n:int, row:GrowthRow):Function
        {
            var greatLand:GreatLand = GrowthGame.land();
            greatLand.addModel(new Model("dot", new <Number>[0, 0, 0]));
            var agents:Vector.<Agent> = new Vector.<Agent>();
            var side:int = Math.ceil(Math.sqrt(n));
            for (var i:int = 0; i < n; i++)
            {
                agents.push(agentAt((i & 1) == 0 ? "ball" : "dot", 1.5 * (i % side), 1.5 * int(i / side), 0));
            }
            return beginFrame(new TightestFitCollider(greatLand), agents);
        }

        private static function beginSizes(n:int, row:GrowthRow):Function
        {
            return beginFrame(new BinCollider(GrowthGame.land()), ofSizes(n));
        }

        private static function beginMovingSizes(n:int, row:GrowthRow):Function
        {
            return moving(new Collision(new TightestFitCollider(GrowthGame.land())), ofSizes(n), 0.3);
        }

        // Sizes from 1e-6 to 1e4, each far from the others.
        private static function ofSizes(n:int):Vector.<Agent>
        {
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < n; i++)
            {
                var size:Number = Math.pow(10, i % 11 - 6);
                var agent:Agent = agentAt("ball", 3 * size * int(i / 11), 3 * size, 0);
                agent.size = size;
                agents.push(agent);
            }
            return agents;
        }

        // Sizes from 1e-6 to 1e6, anywhere in a world in which few touch.
        private static function beginApart(n:int, row:GrowthRow):Function
        {
            var random:SeededRandom = new SeededRandom(12);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < n; i++)
            {
                var agent:Agent = agentAt("ball", random.between(-9e8, 9e8), random.between(-9e8, 9e8), 0);
                agent.size = random.logBetween(1e-6, 1e6);
                agents.push(agent);
            }
            return moving(new Collision(new TightestFitCollider(GrowthGame.land())), agents, 0.01);
        }

        private static function beginFarAbove(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5);
            var width:Number = 1.5 * Math.sqrt(n);
            agents.push(agentAt("ball", width / 2, width / 2, 10 * width));
            agents[n].size = 3 * width;
            return moving(new Collision(new TightestFitCollider(GrowthGame.land())), agents, 0.001);
        }

        // One agent above all others, and one along them.
        private static function beginLarge(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5);
            var greatLand:GreatLand = GrowthGame.land();
            greatLand.addModel(new Model("pole", new <Number>[0, 0, 0, 1, 0, 0, 0, 0.0001, 0, 0, 0, 0.0001]));
            agents.push(agentAt("ball", 0, 0, 2), agentAt("pole", 0, 0.8, 0));
            agents[n].size = agents[n + 1].size = 2 * Math.sqrt(n);
            return moving(new Collision(new TightestFitCollider(greatLand)), agents, 0.001);
        }

        // From an agent to the next the distance grows by a factor, up to 8e8. The first are so far that few touch.
        private static function beginFarApart(n:int, row:GrowthRow):Function
        {
            var first:Number = Math.sqrt(n);
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < n; i++)
            {
                agents.push(agentAt("ball", Math.pow(first, 1 - i / n) * Math.pow(8e8, i / n),
                            -Math.pow(first, 1 - i * 7 % n / n) * Math.pow(8e8, i * 7 % n / n), 0));
            }
            return moving(new Collision(new TightestFitCollider(GrowthGame.land())), agents, 0.001);
        }

        private static function beginChanging(n:int, row:GrowthRow):Function
        {
            var collision:Collision = new Collision(new TightestFitCollider(GrowthGame.land()));
            collision.onCollisionEnd("turtles", "turtles", pass);
            return function():Object
            {
                collision.update(GrowthGame.square(n, "ball", 0.9));
                return collision;
            };
        }

        private static function beginSnapshots(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 0.9);
            var collision:Collision = new Collision(new TightestFitCollider(GrowthGame.land()));
            collision.onCollisionEnd("turtles", "turtles", pass);
            collision.update(agents);
            return function():Object
            {
                collision.restore(collision.snapshot(), agents);
                return collision;
            };
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
                var agents:Vector.<Agent> = new <Agent>[agentAt("row", 0, 0, 0), agentAt("row", 0.5, 0, 0)];
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

        private static function keep(collider:Agent, collidee:Agent, contact:Contact):void
        {
            collider.color = contact.depth;
        }

        private static function pass(collider:Agent, collidee:Agent):void
        {
            collider.color = collidee.color;
        }
    }
}
