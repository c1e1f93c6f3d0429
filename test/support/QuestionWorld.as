package support
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.queries.AgentFilter;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.Footing;
    import starlogo.queries.RayHit;
    import starlogo.queries.ShapeHit;
    import starlogo.queries.WalkOptions;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    /**
     * A small world in which every question of the engine is asked. Answers are texts of all their numbers, so that two of them can be
     * compared.
     */
    public final class QuestionWorld
    {
        /** The systems that the constructor knows. */
        public static const SYSTEMS:Array = ["bins", "tightest fits", "hierarchies", "hierarchies to level 2", "triangles", "combinations", "combinations, exact"];

        /** The questions that <code>ask()</code> knows. */
        public static const QUESTIONS:Array = ["update", "colliding", "contacts", "contacts with the ground", "contacts with the edges", "near", "nearest", "near a point",
                "in a cone", "distances", "distances to the ground", "distances to the edges", "distances to points", "cast", "castAll", "canSee", "castShape",
                "castShapeAll", "castAgent", "castAgentAll", "overlapping", "touching", "touches an edge", "would touch at", "moveUntilTouch", "slide", "walk"];

        private static const KINDS:Array = ["tightest", "tightest", "tightest", "sphere", "box", "capsule"];

        /** Of one model: the one that asks, and another. Then others. */
        public var agents:Vector.<Agent>;

        public var collider:Collider;
        public var queries:AgentQueries;
        public var bounds:WorldBounds = new WorldBounds(-6, -6, -4, 5, 6, 7);

        /** The ground; null if the world has none. */
        public var terrain:Terrain;

        /** What rays begin with: an origin, and a direction. */
        public var origin:Vector3D;
        public var direction:Vector3D;

        /** A motion. */
        public var way:Vector3D;

        /** A structure that is asked about. */
        public var structure:BoundingStructure;

        /** The agents that count in questions; null for all. */
        public var filter:AgentFilter = null;

        /** The agent that questions move: the first one, or another one. */
        public var mover:Agent;

        /** The pairs of the last "update": two agents each, and the contact's text. */
        public var pairs:Array;

        private var _collision:Collision;

        /**
         * A world without agents.
         *
         * @param land has the models
         * @param system one of SYSTEMS
         */
        public function QuestionWorld(land:GreatLand, system:String)
        {
            collider = EachCollider.make(system == "hierarchies to level 2" ? "hierarchies" : system, land);
            if (system == "hierarchies to level 2")
            {
                HierarchicalCollider(collider).maxDepth = 2;
            }
            _collision = new Collision(collider);
            _collision.bounds = bounds;
            for each (var breed:String in [Collision.ANY_BREED, Collision.TERRAIN, Collision.EDGE])
            {
                _collision.onCollision(Collision.ANY_BREED, breed, function(a:Agent, b:Agent, contact:Contact):void
                    {
                        pairs.push([a, b, nameOf(a) + " and " + nameOf(b) + ": " + textOf(contact)]);
                    });
            }
            queries = new AgentQueries(_collision);
        }

        /**
         * Begins anew, with other agents.
         *
         * @param names of the models, the one that asks first
         * @param seed makes the same agents again
         */
        public function begin(names:Array, seed:int):void
        {
            var random:SeededRandom = new SeededRandom(seed);
            var isAtEdge:Boolean = random.chance(0.4);
            agents = new Vector.<Agent>();
            for (var i:int = 0; i < 6; i++)
            {
                var agent:Agent = agentAt(i < 2 ? names[0] : random.pick(names), random.between(-1.2, 1.2), random.between(-1.2, 1.2), random.between(0, 1), i < 4 ? "turtles" : "rocks");
                agent.heading = random.pick([0, 90, 200, random.between(0, 360)]);
                agent.pitch = random.pick([0, 0, random.between(-90, 90)]);
                agent.roll = random.pick([0, 0, random.between(-90, 90)]);
                agent.size = random.pick([1, 1, random.between(0.4, 2.5)]);
                agent.hierarchical = random.chance();
                agent.collideAs = random.pick(KINDS);
                agents.push(agent);
            }
            if (isAtEdge)
            {
                agents[0].moveTo(random.between(3.8, 5), random.between(-1, 1), random.between(0, 1));
                agents[1].moveTo(agents[0].x - 0.5, agents[0].y + random.between(-0.5, 0.5), agents[0].z);
            }
            makeGround(names, random);
            origin = new Vector3D(random.between(-4, 4), random.between(-4, 4), random.between(-1, 4));
            direction = new Vector3D(agents[1].x - origin.x, agents[1].y - origin.y, agents[1].z + random.between(0, 0.8) - origin.z);
            way = new Vector3D(random.between(-2, 2), random.between(-2, 2), random.pick([0, random.between(-1, 1)]));
            structure = newStructure(random);
            mover = agents[0];
            queries.update(agents);
        }

        /** Asks a question. The answer is a text. A world whose agents were moved by a question has to begin anew. */
        public function ask(question:String):String
        {
            var me:Agent = agents[0];
            switch (question)
            {
                case "update":
                    return update();
                case "colliding":
                    return ofEach(function(other:Agent):*
                        {
                            return collider.areColliding(me, other);
                        });
                case "contacts":
                    return ofEach(function(other:Agent):*
                        {
                            return textOf(collider.contactOf(me, other));
                        });
                case "contacts with the ground":
                    return terrain == null ? "" : textOf(collider.contactOf(me, terrain.agent)) + textOf(collider.contactOf(terrain.agent, agents[1]));
                case "contacts with the edges":
                    return textOf(collider.contactOf(me, bounds.agent)) + textOf(collider.contactOf(bounds.agent, agents[2]));
                case "near":
                    return namesOf(queries.near(me, 1.5, filter)) + queries.countNear(me, 1.5, filter);
                case "nearest":
                    return nameOf(queries.nearest(me, Infinity, filter)) + namesOf(queries.nearestFew(me, 3, Infinity, filter));
                case "near a point":
                    return namesOf(queries.nearPoint(origin, 4, filter)) + queries.countNearPoint(origin, 4, filter) + nameOf(queries.nearestToPoint(origin, Infinity, filter));
                case "in a cone":
                    return namesOf(queries.inCone(me, 3, 140, filter));
                case "distances":
                    return ofEach(distanceTo);
                case "distances to the ground":
                    return terrain == null ? "" : distanceTo(terrain.agent);
                case "distances to the edges":
                    return distanceTo(bounds.agent);
                case "distances to points":
                    var nearest:Vector3D = new Vector3D();
                    return queries.distanceToPoint(me, origin, nearest) + " " + nearest + ofEach(function(other:Agent):*
                        {
                            return queries.distanceToPoint(other, way);
                        });
                case "cast":
                    return textOfRay(queries.cast(origin, direction, Infinity, filter));
                case "castAll":
                    return textOfRays(queries.castAll(origin, direction, Infinity, filter));
                case "canSee":
                    return ofEach(function(other:Agent):*
                        {
                            return queries.canSee(me, other, filter);
                        });
                case "castShape":
                    return textOfShape(queries.castShape(structure, way.x, way.y, way.z, filter));
                case "castShapeAll":
                    return textOfShapes(queries.castShapeAll(structure, way.x, way.y, way.z, filter));
                case "castAgent":
                    return textOfShape(queries.castAgent(me, way.x, way.y, way.z, filter));
                case "castAgentAll":
                    return textOfShapes(queries.castAgentAll(me, way.x, way.y, way.z, filter));
                case "overlapping":
                    return namesOf(queries.overlapping(structure, filter));
                case "touching":
                    return namesOf(queries.touching(me, filter)) + queries.touchesAny(me, filter);
                case "touches an edge":
                    return ofEach(function(other:Agent):*
                        {
                            return queries.touchesEdge(other, bounds);
                        }) + queries.touchesEdge(me, bounds);
                case "would touch at":
                    return queries.wouldTouchAt(me, me.x + way.x / 2, me.y + way.y / 2, me.z + way.z / 2, filter) + " " + queries.wouldTouchAt(me, me.x + way.x, me.y + way.y, me.z + way.z, filter);
                case "moveUntilTouch":
                    var contact:Contact = new Contact();
                    return queries.moveUntilTouch(mover, way.x, way.y, way.z, filter, contact) + " " + placeOf(mover) + (contact.time < 1 ? textOf(contact) : "");
                case "slide":
                    return queries.slide(mover, way.x, way.y, way.z, filter) + " " + placeOf(mover);
                case "walk":
                    var options:WalkOptions = new WalkOptions();
                    options.filter = filter;
                    var footing:Footing = queries.walk(mover, way.x, way.y, options);
                    return [footing.stands, nameOf(footing.on), footing.normal, footing.part, footing.pushed, placeOf(mover), mover.heading].join(" ");
                default:
                    throw new ArgumentError("unknown question: " + question);
            }
        }

        /** The number of an agent, or what it stands for. */
        public function nameOf(agent:Agent):String
        {
            return agent == null ? "none" : agents.indexOf(agent) >= 0 ? String(agents.indexOf(agent)) : agent === bounds.agent ? "edges" : "ground";
        }

        private function makeGround(names:Array, random:SeededRandom):void
        {
            terrain = null;
            var isBlocky:Boolean = random.chance();
            if (random.chance())
            {
                terrain = new Terrain(9, 9, 1.5, -6, -6);
                terrain.isBlocky = isBlocky;
                fillHeights(terrain, function(column:int, row:int):Number
                    {
                        return random.between(-0.5, 0.6);
                    });
            }
            else
            {
                // a cube to stand on, and no ground
                agents[5].shape = "cube";
                agents[5].setQuaternion(0, 0, 0, 1);
                agents[5].size = 8;
                agents[5].moveTo(0, 0, -8);
            }
            _collision.terrain = terrain;
        }

        private function newStructure(random:SeededRandom):BoundingStructure
        {
            var middle:Vector3D = new Vector3D(random.between(-1.5, 1.5), random.between(-1.5, 1.5), random.between(0, 1.5));
            var end:Vector3D = middle.add(new Vector3D(random.normal() / 3, random.normal() / 3, random.normal() / 3));
            switch (random.integer(0, 2))
            {
                case 0:
                    return new Sphere(middle, random.between(0, 0.6));
                case 1:
                    return new Capsule(middle, end, random.between(0, 0.4));
                default:
                    return new Box(middle, new Vector3D(0.6, 0.8, 0), new Vector3D(-0.8, 0.6, 0), Vector3D.Z_AXIS, random.between(0, 0.6), random.between(0, 0.4), random.between(0, 0.5));
            }
        }

        private function update():String
        {
            pairs = [];
            _collision.update(agents);
            return pairs.map(function(pair:Array, ...rest):String
                {
                    return pair[2];
                }).join("; ") + _collision.handlerErrors.length;
        }

        private function ofEach(answer:Function):String
        {
            var answers:Array = [];
            for (var i:int = 1; i < agents.length; i++)
            {
                answers.push(answer(agents[i]));
            }
            return answers.join("; ");
        }

        private function distanceTo(other:Agent):String
        {
            var a:Vector3D = new Vector3D();
            var b:Vector3D = new Vector3D();
            return queries.distance(agents[0], other, a, b) + " from " + a + " to " + b;
        }

        private function namesOf(list:Vector.<Agent>):String
        {
            var names:Array = [];
            for each (var agent:Agent in list)
            {
                names.push(nameOf(agent));
            }
            return "[" + names.join() + "]";
        }

        private function textOfRays(hits:Vector.<RayHit>):String
        {
            var texts:Array = [];
            for each (var hit:RayHit in hits)
            {
                texts.push(textOfRay(hit));
            }
            return texts.join("; ");
        }

        private function textOfShapes(hits:Vector.<ShapeHit>):String
        {
            var texts:Array = [];
            for each (var hit:ShapeHit in hits)
            {
                texts.push(textOfShape(hit));
            }
            return texts.join("; ");
        }

        private function textOfRay(hit:RayHit):String
        {
            return hit == null ? "none" : [nameOf(hit.agent), hit.distance, hit.point, hit.normal, hit.triangle].join(" ");
        }

        private function textOfShape(hit:ShapeHit):String
        {
            return hit == null ? "none" : [nameOf(hit.agent), hit.time, hit.point, hit.normal].join(" ");
        }

        private static function textOf(contact:Contact):String
        {
            return "(" + [contact.time, contact.point, contact.normal, contact.depth, contact.approachSpeed].join(" ") + ")";
        }

        private static function placeOf(agent:Agent):String
        {
            return [agent.x, agent.y, agent.z].join(" ");
        }
    }
}
