package growth
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.Sphere;
    import starlogo.collision.BinCollider;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.Model;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.RayHit;
    import support.agentAt;

    /** Questions: n agents, each of which asks one. */
    public final class QueryRows
    {
        private static const FOUND:Vector.<Agent> = new Vector.<Agent>();
        private static const HIT:RayHit = new RayHit();

        /** All rows. */
        public static function get all():Array
        {
            return [
                    ofEach("near", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.near(agent, 3, null, FOUND);
                        }),
                    ofEach("countNear, far", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.countNear(agent, 1e6);
                        }),
                    ofEach("nearest", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.nearest(agent);
                        }),
                    ofEach("nearestFew 8", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.nearestFew(agent, 8, Infinity, null, FOUND);
                        }),
                    ofEach("inCone", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.inCone(agent, 4, 60, null, FOUND);
                        }),
                    ofEach("touching", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.touching(agent, null, FOUND);
                        }),
                    ofEach("touching, of trees and triangles", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.touching(agent, null, FOUND);
                        }, true),
                    ofEach("overlapping", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.overlapping(new Sphere(new Vector3D(agent.x, agent.y, 0), 2), null, FOUND);
                        }),
                    ofEach("wouldTouchAt", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.wouldTouchAt(agent, agent.x + 0.3, agent.y, 0);
                        }),
                    ofEach("cast", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.cast(new Vector3D(agent.x - 0.8, agent.y - 0.8, 0.5), new Vector3D(1, 2, 0), 20, null, HIT);
                        }),
                    ofEach("canSee", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.canSee(agent, queries.nearestToPoint(new Vector3D(agent.x + 8, agent.y + 3, 0)));
                        }),
                    ofEach("castAgent", function(queries:AgentQueries, agent:Agent):Object
                        {
                            return queries.castAgent(agent, 3, 2, 0);
                        }),
                    ofEach("moveUntilTouch, then refresh", function(queries:AgentQueries, agent:Agent):Object
                        {
                            queries.moveUntilTouch(agent, 0.2, 0.1, 0);
                            queries.refresh(agent);
                            return agent;
                        }),
                    ofEach("slide, then refresh", function(queries:AgentQueries, agent:Agent):Object
                        {
                            queries.slide(agent, 0.4, 0.1, 0);
                            queries.refresh(agent);
                            return agent;
                        }),
                    ofEach("refresh, then nearest", function(queries:AgentQueries, agent:Agent):Object
                        {
                            agent.moveTo(agent.x + 0.7, agent.y + 0.2, 0);
                            queries.refresh(agent);
                            return queries.nearest(agent);
                        }),
                    new GrowthRow("ask: nearest of one far wolf", "sheep", 100, 200000, beginFarWolf),
                    new GrowthRow("ask: nearest below one huge agent", "agents", 100, 200000, beginBelow),
                    new GrowthRow("ask: rays past parallel diagonal rods", "rods", 100, 4000, beginRods).admitted(),
                    new GrowthRow("ask: the distance of models of equal triangles", "triangles", 100, 4000, beginEqualTriangles).admitted(),
                    new GrowthRow("ask: a ray past all of them", "agents", 100, 1000000, beginLongRays),
                    new GrowthRow("ask: nearest of agents in one place", "agents", 100, 1000000, beginHeap),
                    new GrowthRow("ask: nearest, sizes over many orders", "agents", 100, 200000, beginSizes)];
        }

        // Agents in a square; every fourth touches the next.
        private static function ofEach(name:String, ask:Function, areTrees:Boolean = false):GrowthRow
        {
            return new GrowthRow("ask: " + name, "agents", 50, 200000, function(n:int, row:GrowthRow):Function
                {
                    var agents:Vector.<Agent> = GrowthGame.square(n, areTrees ? "cube" : "ball", 1.5);
                    for (var i:int = 0; i < n; i += 4)
                    {
                        agents[i].moveTo(agents[i].x + 0.7, agents[i].y, 0);
                        agents[i].hierarchical = areTrees;
                    }
                    var collider:CombinationCollider = new CombinationCollider(GrowthGame.land(areTrees));
                    collider.exact = areTrees;
                    return asking(collider, agents, ask);
                });
        }

        private static function asking(system:CollisionSystem, agents:Vector.<Agent>, ask:Function):Function
        {
            return function():Object
            {
                var queries:AgentQueries = new AgentQueries(system);
                queries.update(agents);
                for each (var agent:Agent in agents)
                {
                    ask(queries, agent);
                }
                return queries;
            };
        }

        private static function beginLongRays(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5);
            var system:CollisionSystem = new TightestFitCollider(GrowthGame.land());
            return function():Object
            {
                var queries:AgentQueries = new AgentQueries(system);
                queries.update(agents);
                for (var i:int = 0; i < Math.sqrt(n); i++)
                {
                    queries.cast(new Vector3D(-5, 1.5 * i + 0.75, 0.5), new Vector3D(1, 0, 0), Infinity, null, HIT);
                }
                return queries;
            };
        }

        private static function beginFarWolf(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5);
            agents.push(agentAt("ball", -300, -300, 0, "wolves"));
            var wolves:AgentFilter = new AgentFilter();
            wolves.breeds = new <String>["wolves"];
            return asking(new TightestFitCollider(GrowthGame.land()), agents, function(queries:AgentQueries, agent:Agent):Object
                {
                    return queries.nearest(agent, Infinity, wolves);
                });
        }

        private static function beginBelow(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5);
            var width:Number = 1.5 * Math.sqrt(n);
            agents.push(agentAt("ball", width / 2, width / 2, 10 * width));
            agents[n].size = 3 * width;
            return asking(new TightestFitCollider(GrowthGame.land()), agents, function(queries:AgentQueries, agent:Agent):Object
                {
                    return queries.nearest(agent) && queries.cast(new Vector3D(agent.x, agent.y, 2), new Vector3D(0, 0, 1), Infinity, null, HIT);
                });
        }

        // Thin rods side by side, all at 45 degrees and much longer than they are apart. A ray goes down between each two.
        private static function beginRods(n:int, row:GrowthRow):Function
        {
            var greatLand:GreatLand = GrowthGame.land();
            greatLand.addModel(new Model("rod", new <Number>[-0.5, -0.0001, 0, 0.5, -0.0001, 0, 0.5, 0.0001, 0, -0.5, 0.0001, 0, 0, 0, 0.0002]));
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < n; i++)
            {
                var rod:Agent = agentAt("rod", i, -i, 0);
                rod.size = 4 * n;
                rod.heading = 45;
                agents.push(rod);
            }
            return asking(new TightestFitCollider(greatLand), agents, function(queries:AgentQueries, agent:Agent):Object
                {
                    return queries.cast(new Vector3D(agent.x + 0.5, agent.y - 0.5, 10), new Vector3D(0, 0, -1), Infinity, null, HIT);
                });
        }

        // Two models apart, each one triangle n times.
        private static function beginEqualTriangles(n:int, row:GrowthRow):Function
        {
            var corners:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < n; i++)
            {
                corners.push(0, 1, 2);
            }
            var greatLand:GreatLand = GrowthGame.land(true);
            greatLand.addModel(new Model("leaf", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], corners));
            var collider:HierarchicalCollider = new HierarchicalCollider(greatLand);
            collider.exact = true;
            var agents:Vector.<Agent> = new <Agent>[agentAt("leaf", 0, 0, 0), agentAt("leaf", 1.5, 0.3, 0.2)];
            return function():Object
            {
                var queries:AgentQueries = new AgentQueries(collider);
                queries.update(agents);
                return queries.distance(agents[0], agents[1]);
            };
        }

        private static function beginHeap(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 0);
            var system:CollisionSystem = new BinCollider(GrowthGame.land());
            return function():Object
            {
                var queries:AgentQueries = new AgentQueries(system);
                queries.update(agents);
                for (var i:int = 0; i < 10; i++)
                {
                    queries.nearest(agents[i]);
                }
                return queries;
            };
        }

        private static function beginSizes(n:int, row:GrowthRow):Function
        {
            var agents:Vector.<Agent> = GrowthGame.square(n, "ball", 1.5);
            for (var i:int = 0; i < n; i++)
            {
                agents[i].size = Math.pow(10, i % 6 - 5);
            }
            return asking(new TightestFitCollider(GrowthGame.land()), agents, function(queries:AgentQueries, agent:Agent):Object
                {
                    return queries.nearest(agent) && queries.touchesAny(agent);
                });
        }
    }
}
