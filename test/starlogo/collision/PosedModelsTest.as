package starlogo.collision
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.models.CookedModel;
    import starlogo.models.Model;
    import starlogo.queries.AgentQueries;
    import starlogo.queries.RayHit;
    import support.BruteForce;
    import support.Complaints;
    import support.Effort;
    import support.EveryTriangle;
    import support.PlainDistance;
    import support.QuestionModels;
    import support.QuestionWorld;
    import support.SolidAngles;
    import support.agentAt;

    use namespace engine;

    /** Models in random poses, as frames and questions see them, against loops over all triangles and against models made anew. */
    public class PosedModelsTest
    {
        public static const FIXTURES:Array = QuestionModels.FIXTURES;

        private static const KINDS:Array = ["cube", "crossed", "hollow", "doll", "apart", "open cube", "both windings"];

        // Distances below this are left to rounding.
        private static const NEAR:Number = 1e-9;

        private var _wrong:Complaints = new Complaints();

        /** Two posed models, cooked or not, prepared or not: a loop over the pairs of triangles, and solid angles for what is inside. */
        [Test]
        public function exactPairsAreLikeBruteForce():void
        {
            var random:SeededRandom = new SeededRandom(7361);
            var count:int = Effort.choose(60, 6000);
            var touches:int = 0;
            var insides:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var land:GreatLand = new GreatLand();
                land.loadTightestFit = false;
                land.prepareExact = random.chance();
                var kinds:Array = [random.pick(KINDS), random.pick(KINDS)];
                var models:Array = [copyOf(kinds[0], "a", random.chance()), copyOf(kinds[1], "b", random.chance())];
                land.addModel(models[0]);
                land.addModel(models[1]);
                var collider:HierarchicalCollider = new HierarchicalCollider(land);
                collider.exact = true;
                var agents:Array = [agentAt("a", 0, 0, 0), agentAt("b", 0, 0, 0)];
                for (var k:int = 0; k < 3; k++)
                {
                    var known:Array = [];
                    for (var m:int = 0; m < 2; m++)
                    {
                        pose(models[m], kinds[m], random);
                        known.push(new Model("pose " + i + " " + k + " " + m, models[m].vertices, onceEach(kinds[m], models[m].triangles), Model.AS_GIVEN));
                    }
                    var isSmall:Boolean = random.chance(0.6);
                    agents[1].moveTo(random.between(-0.6, 0.6), random.between(-0.6, 0.6), random.between(-0.2, 0.8));
                    agents[1].setQuaternion(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1));
                    agents[1].size = isSmall ? 0.06 : 1;
                    var distance:Number = distanceOf(agents[0], known[0], agents[1], known[1]);
                    var isInside:Boolean = SolidAngles.isOneInside(agents[0], known[0], agents[1], known[1]);
                    if (distance > 0 && distance < NEAR)
                    {
                        continue;
                    }
                    touches += distance == 0 ? 1 : 0;
                    insides += distance > 0 && isInside ? 1 : 0;
                    _wrong.addIf(collider.areColliding(agents[0], agents[1]) != (distance == 0 || isInside), "pair",
                            kinds + ", " + i + " " + k + ": " + distance + (isInside ? ", inside" : ""));
                }
            }
            _wrong.assertNone();
            assertTrue(touches + " touch, " + insides + " are inside", touches > count / 3 && touches < 2 * count && insides > count / 10);
        }

        /** Rays at posed models, against a loop over the triangles. */
        [Test]
        public function raysAreLikeBruteForce():void
        {
            var random:SeededRandom = new SeededRandom(7362);
            var land:GreatLand = new GreatLand();
            land.loadTightestFit = false;
            var models:Object = {};
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for each (var kind:String in ["sphere", "crossed", "open cube"])
            {
                models[kind] = copyOf(kind, kind, random.chance());
                land.addModel(models[kind]);
                agents.push(agentAt(kind, random.between(-1, 1), random.between(-1, 1), random.between(0, 1)));
            }
            var collider:HierarchicalCollider = new HierarchicalCollider(land);
            collider.exact = true;
            var queries:AgentQueries = new AgentQueries(collider);
            var corners:Vector.<Number> = new Vector.<Number>();
            var count:int = Effort.choose(60, 2000);
            var hits:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                for each (var model:Model in models)
                {
                    pose(model, model.name, random);
                }
                queries.update(agents);
                var origin:Vector3D = new Vector3D(random.between(-4, 4), random.between(-4, 4), 6);
                var direction:Vector3D = new Vector3D(agents[i % 3].x + random.between(-0.3, 0.3), agents[i % 3].y + random.between(-0.3, 0.3),
                        agents[i % 3].z + 0.4).subtract(origin);
                direction.normalize();
                var nearest:Number = Infinity;
                for each (var agent:Agent in agents)
                {
                    EveryTriangle.place(agent.freshPlacement(), models[agent.shape], corners);
                    for (var at:int = 0; at < corners.length; at += 9)
                    {
                        nearest = Math.min(nearest, PlainDistance.alongRay(origin, direction, corners, at));
                    }
                }
                var hit:RayHit = queries.cast(origin, direction);
                var found:Number = hit == null ? Infinity : hit.distance;
                hits += hit == null ? 0 : 1;
                _wrong.addIf(!(found == nearest || Math.abs(found - nearest) < NEAR), "ray", i + ": " + found + ", not " + nearest);
            }
            _wrong.assertNone();
            assertTrue(hits + " hits", hits > count / 3);
        }

        /** After the way back to the first vertices, every question in every system has the answer of a model that was never posed, to the last bit. */
        [Test]
        public function nothingIsLeftOfAPose():void
        {
            var random:SeededRandom = new SeededRandom(7363);
            var kinds:Array = QuestionModels.SMALL.concat("sphere", "sheet", "cloud");
            var rounds:int = Effort.choose(1, 10);
            for (var i:int = 0; i < rounds * kinds.length; i++)
            {
                var names:Array = [kinds[i % kinds.length], "cube"];
                var system:String = QuestionWorld.SYSTEMS[i % QuestionWorld.SYSTEMS.length];
                var lands:Array = [new GreatLand(), new GreatLand()];
                var posed:Array = [];
                for each (var land:GreatLand in lands)
                {
                    for each (var name:String in names)
                    {
                        var model:Model = asGiven(name);
                        land.addModel(model);
                        if (land == lands[1])
                        {
                            posed.push(model);
                        }
                    }
                }
                var plain:QuestionWorld = new QuestionWorld(lands[0], system);
                var world:QuestionWorld = new QuestionWorld(lands[1], system);
                for each (var question:String in QuestionWorld.QUESTIONS)
                {
                    if (random.chance(0.3))
                    {
                        for each (model in posed)
                        {
                            pose(model, model.name, random);
                        }
                        world.begin(names, i + 1);
                        world.ask(random.pick(QuestionWorld.QUESTIONS));
                        for each (model in posed)
                        {
                            model.pose(QuestionModels.of(model.name).vertices);
                        }
                    }
                    plain.begin(names, i + 1);
                    world.begin(names, i + 1);
                    var expected:String = plain.ask(question);
                    _wrong.addIf(world.ask(question) != expected, question, names + " in " + system);
                }
            }
            _wrong.assertNone();
        }

        /** Frames in which few agents change, and one of the models: the pairs that are kept are those of a new Collision. */
        [Test]
        public function framesFollowThePoses():void
        {
            var random:SeededRandom = new SeededRandom(7364);
            for each (var isExact:Boolean in [false, true])
            {
                var land:GreatLand = new GreatLand();
                land.loadTightestFit = false;
                var models:Array = [copyOf("sphere", "sphere", false), copyOf("doll", "doll", false), copyOf("open cube", "open cube", true)];
                var agents:Vector.<Agent> = new Vector.<Agent>();
                for (var i:int = 0; i < 60; i++)
                {
                    var agent:Agent = agentAt(models[i < 2 ? 0 : (i < 30 ? 1 : 2)].name, random.between(-4, 4), random.between(-4, 4), random.between(0, 1));
                    agents.push(agent);
                }
                for each (var model:Model in models)
                {
                    land.addModel(model);
                }
                var collider:HierarchicalCollider = new HierarchicalCollider(land);
                collider.exact = isExact;
                var pairs:Vector.<Agent>;
                var collision:Collision = new Collision(collider);
                collision.onCollision(Collision.ANY_BREED, Collision.ANY_BREED, function(a:Agent, b:Agent):void
                    {
                        // the handler is called once for each order
                        if (agents.indexOf(a) < agents.indexOf(b))
                        {
                            pairs.push(a, b);
                        }
                    });
                var changes:int = 0;
                var before:int = -1;
                for (var frame:int = 0; frame < 30; frame++)
                {
                    if (frame % 3 > 0)
                    {
                        // two agents have the first model
                        model = models[frame % 9 == 8 ? 1 : 0];
                        pose(model, model.name, random);
                    }
                    agents[random.integer(0, 59)].moveTo(random.between(-4, 4), random.between(-4, 4), random.between(0, 1));
                    pairs = new Vector.<Agent>();
                    collision.update(agents);
                    var fresh:HierarchicalCollider = new HierarchicalCollider(land);
                    fresh.exact = isExact;
                    assertEquals("frame " + frame, "", BruteForce.difference(BruteForce.ask(fresh, agents), pairs));
                    changes += before == pairs.length ? 0 : 1;
                    before = pairs.length;
                }
                assertTrue(changes + " changes", changes > 10);
            }
        }

        // A new model of a kind, as its vertices are. If it is cooked, its results come from a file.
        private static function copyOf(kind:String, name:String, isCooked:Boolean):Model
        {
            var model:Model = new Model(name, QuestionModels.of(kind).vertices, QuestionModels.of(kind).triangles, Model.AS_GIVEN);
            return isCooked ? CookedModel.fromBytes(name, new GreatLand().cook(model)) : model;
        }

        // The triangles of a kind. The windings of both copies of a surface cancel each other, so the reference has the first one alone.
        private static function onceEach(kind:String, triangles:Vector.<uint>):Vector.<uint>
        {
            return kind == "both windings" ? triangles.slice(0, triangles.length / 2) : triangles;
        }

        private static function asGiven(name:String):Model
        {
            return copyOf(name, name, false);
        }

        // Twists, bends and stretches a model of a kind.
        private static function pose(model:Model, kind:String, random:SeededRandom):void
        {
            var twist:Number = random.between(-0.7, 0.7);
            var bend:Number = random.between(-0.3, 0.3);
            var stretch:Number = random.between(0.7, 1.4);
            var shift:Number = random.between(-0.5, 0.5);
            var posed:Vector.<Number> = QuestionModels.of(kind).vertices.slice();
            for (var i:int = 0; i < posed.length; i += 3)
            {
                var angle:Number = twist * posed[i + 2];
                var x:Number = Math.cos(angle) * posed[i] - Math.sin(angle) * posed[i + 1];
                var y:Number = Math.sin(angle) * posed[i] + Math.cos(angle) * posed[i + 1];
                posed[i] = stretch * x + bend * posed[i + 2];
                posed[i + 1] = y / stretch + shift;
                posed[i + 2] += 0.5 * bend * x * y;
            }
            model.pose(posed);
        }

        // The least distance of two triangles.
        private static function distanceOf(a:Agent, modelA:Model, b:Agent, modelB:Model):Number
        {
            var cornersA:Vector.<Number> = new Vector.<Number>();
            var cornersB:Vector.<Number> = new Vector.<Number>();
            EveryTriangle.place(a.freshPlacement(), modelA, cornersA);
            EveryTriangle.place(b.freshPlacement(), modelB, cornersB);
            var least:Number = Infinity;
            for (var i:int = 0; i < cornersA.length && least > 0; i += 9)
            {
                for (var k:int = 0; k < cornersB.length && least > 0; k += 9)
                {
                    least = Math.min(least, PlainDistance.ofTriangles(cornersA, i, cornersB, k));
                }
            }
            return least;
        }
    }
}
