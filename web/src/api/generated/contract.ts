// Made from proto/openapi.yaml and proto/asyncapi.yaml by "npm run generate"; "npm run check" fails when it is out
// of date. The names that the page uses stand in ../types.ts.

export interface paths {
    "/api/v1/session": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Who asks, and what they may */
        get: operations["showSession"];
        put?: never;
        /**
         * Come in by a browser
         * @description A name with a password, or a token, against a cookie that scripts cannot read and other sites do not send. A session lasts
         *     a week, or as long as the token, and has its scopes.
         */
        post: operations["logIn"];
        /** End the session whose cookie is sent */
        delete: operations["logOut"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/keys": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The tokens and sessions of whoever asks, newest first; never their secrets */
        get: operations["listKeys"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/keys/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                id: string;
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** From now on the key is good for nothing */
        delete: operations["revokeKey"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/assets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** All files, newest first */
        get: operations["listAssets"];
        put?: never;
        /**
         * Keep a file
         * @description The file is read before it is kept. The same bytes under the same name and kind are one asset.
         */
        post: operations["uploadAsset"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/bodies": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** All bodies, newest first */
        get: operations["listBodies"];
        put?: never;
        /** Keep a body; as POST /api/v1/assets?kind=body */
        post: operations["uploadBody"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fabrics": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * The library of fabrics
         * @description By name. A document says a name for the garment or for a piece; `like` takes one with other figures.
         */
        get: operations["listFabrics"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/fabrics/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example single-jersey */
                name: string;
            };
            cookie?: never;
        };
        /** One fabric, with where its figures come from */
        get: operations["showFabric"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/bodies/presets": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Size tables, what a tape measures, and the formats of mesh files
         * @description Every preset has all fourteen measures; what its table does not have comes from proportions.
         */
        get: operations["listBodyPresets"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/bodies/mannequins": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Make a body from measures and keep it as a file
         * @description Every girth that is asked for is met to 5 mm and every length to 10 mm, or the answer is 422 with the measure
         *     that is missed most. The measures in the answer are those that the tape takes back.
         */
        post: operations["makeBody"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/bodies/{id}/figure": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        /**
         * What the tape says of an uploaded body
         * @description Unit and directions are guessed by shape; the figure stands as the guess says, feet on y = 0, facing +z.
         *     Without a guess (a table, a chair) `stance` is null and the mesh is looked at as it lies in the file.
         */
        get: operations["showBodyFigure"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/assets/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        /** What is known of a file */
        get: operations["showAsset"];
        put?: never;
        post?: never;
        /** Remove a file that no project and no job uses */
        delete: operations["removeAsset"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/assets/{id}/content": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        /** The file itself */
        get: operations["assetContent"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/imports": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Read an uploaded pattern file
         * @description Tells what the file holds: its unit and why, sizes, pieces, and what became of every entity, with proposals of
         *     seams (of a specification: its own). Nothing is kept. `document` is a project document to begin with: seams of the
         *     proposals, the body and the name are for the client to put in, before it is sent to /api/v1/projects with `asset`
         *     under the name of `file`. A refusal of outlines (dxf.no_outline, dxf.open_outline, dxf.zero_area,
         *     dxf.self_crossing) may come of layers that are not AAMA's: `layers` says what they are, and
         *     GET /api/v1/assets/{id}/layers lists them.
         */
        post: operations["importPattern"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/assets/{id}/layers": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        /**
         * The layers of an uploaded DXF
         * @description As they are read when nobody says otherwise, also of a file in which no piece can be found so: a drawing of several
         *     layers is kept when it is uploaded, for its layers may be others than the usual ones.
         */
        get: operations["listLayers"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Projects without their documents, newest first */
        get: operations["listProjects"];
        put?: never;
        /**
         * Make a project
         * @description The document is read with all its files, and kept only when a drape could be made of it. Asking again with the
         *     same Idempotency-Key gives the project that was made then, as it is now; with another document or other files
         *     it is refused. Removing a project frees its key.
         */
        post: operations["createProject"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** A project with its document */
        get: operations["showProject"];
        /** Replace a project */
        put: operations["replaceProject"];
        post?: never;
        /** Remove a project; its jobs and files stay unless data is true */
        delete: operations["removeProject"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/edits": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /**
         * What was done to a project, newest first
         * @description The newest 500 steps, 64 MiB of them at most. Replacing a project empties its history.
         */
        get: operations["listEdits"];
        put?: never;
        /**
         * Edit a project
         * @description All edits are done, one after the other, or none. What they did can be undone, and survives a restart; what was
         *     undone before is forgotten. A `where` of /edits/2 names an edit of the request.
         */
        post: operations["editProject"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/undo": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Undo the newest step that is not undone
         * @description The document gets back the bytes that it had before.
         */
        post: operations["undoEdits"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/redo": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Do the oldest undone step again */
        post: operations["redoEdits"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/versions": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** States of a project that were named, newest first */
        get: operations["listVersions"];
        put?: never;
        /**
         * Name the state that a project has, to come back to it
         * @description A version keeps the whole document with its files, whatever becomes of the project and its history. Names are used once
         *     (`versions.taken`).
         */
        post: operations["nameVersion"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/versions/{version}/restore": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @example v_1qedqq1nd5hfbjxpm78j */
                version: components["parameters"]["VersionId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Come back to a version
         * @description One step of the history, which can be undone; none where the project stands so already.
         */
        post: operations["restoreVersion"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/versions/{version}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @example v_1qedqq1nd5hfbjxpm78j */
                version: components["parameters"]["VersionId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Remove a version; the project and its drapes stay */
        delete: operations["removeVersion"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/proposals": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /**
         * Seams that the project's pieces ask for
         * @description Surest first, between edges that no seam has yet; each can be added by an edit add_seam.
         */
        get: operations["proposeSeams"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/bodies": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** The bodies of a project, measured where they stand */
        get: operations["showProjectBodies"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/bodies/{body}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @description Id of a body in the document; one that is not there comes to the others */
                body: string;
            };
            cookie?: never;
        };
        get?: never;
        /**
         * Put a body into a project
         * @description A mannequin, or an uploaded file, which is put upright on the floor as its shape says where `unit`, `up` and
         *     `turn` say nothing else. One step of the project's history. Friction and skin offset stay as they were where
         *     they are not given.
         */
        put: operations["dressProject"];
        post?: never;
        /**
         * Take a body out of a project
         * @description One step of the project's history. What is told by the body must go first.
         */
        delete: operations["undressProject"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/bodies/{body}/landmarks/{landmark}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @description Id of a body in the document */
                body: string;
                /** @description Name of a landmark that the body has or gets */
                landmark: string;
            };
            cookie?: never;
        };
        get?: never;
        /**
         * Move a landmark, or add one
         * @description It comes to the skin nearest to the place. On a standing body it is told from a landmark and the body's height, so
         *     that it goes along when measures change; else by its triangle. One step of the project's history.
         */
        put: operations["moveLandmark"];
        post?: never;
        /**
         * Put a landmark back, or take an added one away
         * @description One step of the project's history. What is told by the landmark must go first.
         */
        delete: operations["forgetLandmark"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/body": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** The bodies of a project as one mesh; as GET /api/v1/jobs/{id}/body */
        get: operations["projectBody"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/arrange": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Place all pieces around the body
         * @description The first body that stands like a person is dressed. Pieces get placements, a skirt or trousers also what holds
         *     them up until friction does: one step of the project's history. The pieces are placed even when an error is
         *     among the findings.
         */
        post: operations["arrangeProject"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/place": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Put one piece on a side of a body part's box
         * @description The piece's middle comes there, its right side outwards. One step of the project's history.
         */
        post: operations["placePiece"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/check": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** The look at a project's start, without a drape */
        get: operations["checkProject"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/start": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** The pieces where a drape would begin */
        get: operations["projectStart"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/pieces": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** The flat pieces for a drawing */
        get: operations["showPieces"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/pattern.dxf": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** The pattern as DXF */
        get: operations["patternDxf"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/pattern.svg": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** The pattern on one sheet as SVG at 1:1 */
        get: operations["patternSvg"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/projects/{id}/pattern.pdf": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        /** The pattern on pages at 1:1, to print and glue */
        get: operations["patternPdf"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * Jobs without their reports, newest first
         * @description What is asked for by several parameters must all fit.
         */
        get: operations["listJobs"];
        put?: never;
        /**
         * Drape a project as it is now
         * @description Durable once it is answered. The job keeps the document and files of this moment. What has been draped before, of the
         *     same document and files by the same program, is answered with a job that has ended with the same results. Asking again with the same
         *     Idempotency-Key gives the job of then, whatever has become of the project since; for another project it is
         *     refused.
         */
        post: operations["submitJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /** A job with what it is doing, or with its report */
        get: operations["showJob"];
        put?: never;
        post?: never;
        /** Remove a job that has ended, with its results */
        delete: operations["removeJob"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/tags": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        get?: never;
        /** Put tags on a job, in place of those that it has */
        put: operations["tagJob"];
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/pause": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Hold a drape where it is */
        post: operations["pauseJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/resume": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Go on with a paused drape */
        post: operations["resumeJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/step": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Let a paused drape go on to its next streamed frame
         * @description It runs until the next frame, or its end, and is paused again.
         */
        post: operations["stepJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/cancel": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** End a drape for good */
        post: operations["cancelJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/retry": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Drape once more what an ended job draped
         * @description A new job of the document and files of then, whatever has become of the project since.
         */
        post: operations["retryJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/go_on": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * Go on with the project as it is by now
         * @description For edits while a drape is under way. Makes a new job of the project in its present state, which begins with the cloth as it hangs just
         *     now, cut to the edited pieces (from the pieces where it does not hang yet), and ends this one as cancelled, with the code `superseded` and
         *     the new job's id as reason_where. Its stream says so in its last message; whoever looks on goes to the new job's stream.
         *     A drape whose pictures are being drawn has come to its end, and keeps it: the new job begins there, and this one gets its pictures and succeeds.
         */
        post: operations["goOnJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/results": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /** The files that a drape left */
        get: operations["listResults"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/results/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
                /** @example final.glb */
                name: string;
            };
            cookie?: never;
        };
        /** One of the files */
        get: operations["resultContent"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/results/{name}/small": {
        parameters: {
            query?: {
                /** @description Pixels; the height follows. A picture that is no wider comes as it is */
                width?: number;
            };
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
                /** @example front.png */
                name: string;
            };
            cookie?: never;
        };
        /** A picture among the results, made smaller */
        get: operations["smallResult"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/movies": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /** The movies of a drape, made, under way and failed */
        get: operations["listMovies"];
        put?: never;
        /**
         * Ask for a movie of a drape that has ended
         * @description It is made once, by turns of owners and behind drapes, and kept among the job's results. Asking again tells how it
         *     stands, and tries again what has failed. What waits when the service stops is made when it is asked for again.
         */
        post: operations["makeMovie"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/movies/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
                /** @example turntable-480x600-25.mp4 */
                name: string;
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Take back a movie that waits or is being made */
        delete: operations["cancelMovie"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/stills": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /** The stills of a drape that were asked for, taken, under way and failed */
        get: operations["listStills"];
        put?: never;
        /**
         * Ask for a still of a drape that has ended, from anywhere
         * @description From a view, or from an own camera (eye), as the cloth looks or coloured by one of its maps with a legend. It is
         *     taken once, by turns of owners and behind drapes, and kept among the job's results. Asking again tells how it stands,
         *     and tries again what has failed. What waits when the service stops is taken when it is asked for again.
         */
        post: operations["takeStill"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/stills/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
                /** @example still-front-ease-800x1000.png */
                name: string;
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Take back a still that waits or is being taken */
        delete: operations["cancelStill"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/report": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /** The report as one page of HTML, with small pictures, the table of fit and the findings */
        get: operations["reportPage"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/log": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /**
         * What the service did for a job, a line of JSON each
         * @description Each line has time, level and event, and what belongs to it: request, attempt, phase, seconds of processor time,
         *     codes of what went wrong. At most 256 KiB, the oldest.
         */
        get: operations["logOfJob"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/pieces": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /**
         * Colours, fabrics and prints of the pieces as they are draped, without their outlines
         * @description Those of the document that the job keeps, whatever has become of the project since.
         */
        get: operations["jobPieces"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/body": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /**
         * The bodies under the cloth, as one mesh
         * @description Bodies that move stand where they began while the job runs, and where they came to once it has ended.
         */
        get: operations["jobBody"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/links": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /** The share links of a job, newest first; never their secrets */
        get: operations["listLinksOfJob"];
        put?: never;
        /**
         * Make a link by which whoever has it sees this job, live or ended, and nothing else
         * @description No account is wanted to open it. The secret is told once and kept as a hash. The page of the link is `page`, whose part behind the
         *     # is never sent to a server. Who sees the cloth sees its shape: the stream and the cloth have its mesh with the places of its
         *     vertices on the flat pieces.
         */
        post: operations["shareJob"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/jobs/{id}/stream": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        /** The moving cloth on a WebSocket (asyncapi.yaml) */
        get: operations["streamJob"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sweeps": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Sweeps without their cells, newest first */
        get: operations["listSweeps"];
        put?: never;
        /**
         * Drape a project on several bodies and of several fabrics
         * @description A drape for each pair of a body and a fabric, as jobs of priority batch under the owner's quotas and turns: all are queued, or none.
         *     Durable once it is answered. A cell that has been draped before, of the same document and files by the same program, has ended already.
         *     A body takes the place of one of the document's: how cloth lies on it, and landmarks that mean the same on it, stay. A fabric
         *     takes the place of what most pieces are cut of; linings and interlinings stay. At most 50 bodies, 50 fabrics and 200 drapes.
         *     Asking again with the same Idempotency-Key gives the sweep of then; for another project it is refused.
         */
        post: operations["submitSweep"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sweeps/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        /** A sweep with what its cells have come to */
        get: operations["showSweep"];
        put?: never;
        post?: never;
        /** Remove a sweep whose drapes have all ended, with the drapes and their results */
        delete: operations["removeSweep"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sweeps/{id}/cancel": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** End all drapes of a sweep that have not ended */
        post: operations["cancelSweep"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sweeps/{id}/table.csv": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        /**
         * The cells as a table, a line each (RFC 4180)
         * @description Ease in mm, tension in percent and shear in degrees that 99 % of the triangles do not reach, crossings at the end and in the worst frame.
         */
        get: operations["sweepTable"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/sweeps/{id}/sheet.png": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        /**
         * Small stills of all cells on one sheet, in rows of bodies and columns of fabrics
         * @description Made when it is asked for. A cell without pictures has its state in words.
         */
        get: operations["sweepSheet"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/events": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /**
         * What becomes of all jobs of whoever asks, as server-sent events
         * @description A `job` event for every new state of every job, and for its removal; its data is a JobEvent on one line, its id a number that
         *     rises by one. A `sweep` event, without a job, follows the end of a sweep's last drape (failed or cancelled where the newest drape of a cell
         *     is) and the removal of the sweep. It is written with the job itself, so that none is lost when the server stops or crashes. A client that comes
         *     back says what it has heard last (Last-Event-ID, as browsers do by themselves) and is told what came since. The newest
         *     thousand are kept; where some between are not any more, or the number is of another store, a `gap` event says so: look at
         *     the jobs then. A comment every 15 s shows that the connection lives. It ends when its key is good no more, and when the server
         *     stops; 16 of an owner may be open (429).
         */
        get: operations["listenToEvents"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The webhooks of whoever asks, newest first */
        get: operations["listWebhooks"];
        put?: never;
        /**
         * Have an address told when a drape has ended
         * @description From now on each job, and each sweep as a whole, that comes to one of the states is told to the address by a POST whose body is a WebhookMessage. Its secret is
         *     told this once. A message brings `Toile-Delivery` with its number, by which what is told twice is known, and `Toile-Signature: t=SECONDS,v1=HEX`,
         *     where HEX is the HMAC-SHA256 of `SECONDS.BODY` under the secret, and SECONDS the Unix time at which it was sent. Any answer of 2xx within 8 s takes it; else it is
         *     told again after 10 s, 1 min, 5 min, 30 min, 2 h, 6 h and 12 h, and then given up. 410 ends it at once. Redirections are not followed. What is to
         *     be told is kept with the job, so that no stop and no crash of the service loses it. Addresses of the loopback and of private networks
         *     are not told unless whoever runs the service allows it (`toile serve --webhooks-to-private`); that is looked at when something is told. An owner has 10 at most.
         */
        post: operations["makeWebhook"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example w_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["WebhookId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** Tell the address nothing any more, not even what waits */
        delete: operations["removeWebhook"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks/{id}/ping": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example w_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["WebhookId"];
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Tell the address something of no job, to try it */
        post: operations["pingWebhook"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/webhooks/{id}/deliveries": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example w_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["WebhookId"];
            };
            cookie?: never;
        };
        /** What the address was told and is to be told, the newest hundred */
        get: operations["listDeliveries"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/links": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** All share links of whoever asks, newest first; never their secrets */
        get: operations["listLinks"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/links/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: string;
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        post?: never;
        /** From now on the link opens nothing, also to who looks on just now */
        delete: operations["revokeLink"];
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        get?: never;
        put?: never;
        /**
         * What a share link shows
         * @description The link's secret against a cookie that is sent to the addresses of this link only, and the job as the link shows it. A program
         *     may show the secret with each request instead (Authorization: Bearer …). Ten wrong ones of an address in a minute,
         *     and further ones are answered with 429. What was a link once is answered with 410 and a code that says what became of it:
         *     `links.expired`, `links.revoked`, `links.removed` (its job).
         */
        post: operations["openLink"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        /** The job that a share link shows, with what it is doing */
        get: operations["showShared"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}/cloth": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        /** The draped cloth (final.obj), to be shown */
        get: operations["sharedCloth"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}/pieces": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        /** Colours and prints of the pieces on the cloth, without their outlines */
        get: operations["sharedPieces"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}/pictures/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
                /** @example front.png */
                name: string;
            };
            cookie?: never;
        };
        /** A picture that is on a piece */
        get: operations["sharedPicture"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}/body": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        /** The bodies under the cloth, as one mesh; as GET /api/v1/jobs/{id}/body */
        get: operations["sharedBody"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}/results/{name}": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
                /** @example front.png */
                name: string;
            };
            cookie?: never;
        };
        /** A file that may be taken home; any other is answered with 403 */
        get: operations["sharedResult"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}/results/{name}/small": {
        parameters: {
            query?: {
                /** @description Pixels; the height follows */
                width?: number;
            };
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
                /** @example front.png */
                name: string;
            };
            cookie?: never;
        };
        /** A still, made smaller */
        get: operations["sharedStill"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}/report": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        /** The report as one page of HTML, where it may be taken home */
        get: operations["sharedReport"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/shared/{id}/stream": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        /** The moving cloth on a WebSocket (asyncapi.yaml), to look at only */
        get: operations["streamShared"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/admin/accounts": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Who there is, with what each keeps; without accounts the one user */
        get: operations["adminAccounts"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/admin/accounts/{id}/lock": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                id: string;
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Let somebody in no more; what they have stays */
        post: operations["lockAccount"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/admin/accounts/{id}/unlock": {
        parameters: {
            query?: never;
            header?: never;
            path: {
                id: string;
            };
            cookie?: never;
        };
        get?: never;
        put?: never;
        /** Let somebody in again, by the keys that they had */
        post: operations["unlockAccount"];
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/admin/jobs": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Everybody’s drapes that have not ended, the oldest first */
        get: operations["adminJobs"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/api/v1/admin/load": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** What the service is doing */
        get: operations["adminLoad"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/healthz": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The process answers */
        get: operations["healthz"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/readyz": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** The store answers and new work is taken */
        get: operations["readyz"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
    "/metrics": {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        /** Figures in the text format of Prometheus */
        get: operations["metrics"];
        put?: never;
        post?: never;
        delete?: never;
        options?: never;
        head?: never;
        patch?: never;
        trace?: never;
    };
}
export type webhooks = Record<string, never>;
export interface components {
    schemas: {
        AdminAccount: {
            id: string;
            /** @description Null for the one user of a server without accounts */
            name: string | null;
            admin: boolean;
            locked: boolean;
            created_ms: number;
            /** @description Uploads, documents and results together */
            bytes: number;
            assets: number;
            projects: number;
            jobs: number;
            unfinished_jobs: number;
        };
        AdminJob: {
            id: string;
            /** @description Id of the account */
            owner: string;
            /** @description Its name */
            account: string | null;
            name: string;
            state: components["schemas"]["JobState"];
            /** @enum {string} */
            priority: "batch" | "interactive";
            /** @description Who works on it; empty while nobody does */
            holder: string;
            attempt: number;
            created_ms: number;
            started_ms: number;
            /** @description Processor time so far */
            worked_s: number;
        };
        AdminLoad: {
            ready: boolean;
            jobs_queued: number;
            jobs_running: number;
            jobs_paused: number;
            viewers: number;
            /** @description Of the disk that the store lies on */
            disk_bytes: number;
            /** @description Of that, what is free for the service */
            disk_free_bytes: number;
            /** @description Since the start, by code */
            store_failures: {
                [key: string]: number;
            };
        };
        /** @enum {string} */
        Scope: "read" | "submit" | "admin";
        Session: {
            /** @description Whether the server has accounts */
            accounts: boolean;
            /** @description Of the account; null where there are none */
            name: string | null;
            scopes: components["schemas"]["Scope"][];
            /** @description When the key ends by which they are known; 0 if it does not */
            expires_ms: number;
        };
        Key: {
            id: string;
            /** @enum {string} */
            kind: "token" | "session";
            label: string;
            scopes: components["schemas"]["Scope"][];
            created_ms: number;
            /** @description 0 if it does not end */
            expires_ms: number;
        };
        /**
         * @example {
         *       "type": "about:blank",
         *       "title": "Unprocessable Content",
         *       "status": 422,
         *       "code": "dxf.truncated",
         *       "detail": "the file ends in the middle of an entity",
         *       "where": "skirt.dxf: line 12"
         *     }
         */
        Problem: {
            /** @constant */
            type: "about:blank";
            /** @description The status's own phrase */
            title: string;
            status: number;
            /** @description Stable; programs match on it */
            code: string;
            /** @description A sentence for a person */
            detail: string;
            /** @description File and line, piece or edge, JSON pointer, header or parameter; empty when there is no place */
            where: string;
        };
        /** @description For the page after this one; null on the last */
        NextCursor: string | null;
        /**
         * @description shape is how a garment hung at the end of a drape (final.hung, proto/hung.md).
         *     specification is GarmentCode's JSON; image a PNG or JPEG (what its bytes say, not its name) of at most 20 MiB and 64
         *     million pixels.
         * @enum {unknown}
         */
        AssetKind: "dxf" | "specification" | "body" | "image" | "shape";
        /**
         * @example {
         *       "id": "a_185b51bfe69fa48fcfaabd3c3951412c",
         *       "kind": "body",
         *       "name": "body.obj",
         *       "size": 99041,
         *       "created_ms": 1795229571125,
         *       "info": {
         *         "vertices": 1650,
         *         "triangles": 3296,
         *         "width_m": 0.41,
         *         "height_m": 1.7,
         *         "depth_m": 0.26,
         *         "closed": true,
         *         "notes": []
         *       }
         *     }
         */
        Asset: {
            id: string;
            kind: components["schemas"]["AssetKind"];
            name: string;
            /** @description bytes */
            size: number;
            created_ms: number;
            /** @description What reading the file told */
            info: components["schemas"]["DxfInfo"] | components["schemas"]["SpecificationInfo"] | components["schemas"]["BodyInfo"] | components["schemas"]["ImageInfo"];
        };
        DxfInfo: {
            /** @description not of a file without pieces */
            mm_per_unit?: number;
            /** @description none where the layers of the file have to be told before any piece can be found */
            pieces: {
                name: string;
                width_mm: number;
                height_mm: number;
                points: number;
                holes: number;
                layer: string;
            }[];
            /** @description What was passed over and why */
            notes: string[];
            note_count: number;
        };
        ImageInfo: {
            /** @enum {unknown} */
            format: "png" | "jpeg";
            /** @description pixels, as it is shown: turned as the camera says */
            width: number;
            height: number;
            /** @description nothing shines through */
            opaque: boolean;
        };
        SpecificationInfo: {
            pieces: number;
            seams: number;
        };
        BodyInfo: {
            vertices: number;
            triangles: number;
            width_m: number;
            height_m: number;
            depth_m: number;
            /** @description No border is left; not told of files that were kept by older servers */
            closed?: boolean;
            /** @description What was mended and what could not be, in sentences */
            notes?: string[];
        };
        Mannequin: components["schemas"]["mannequin"];
        /** @enum {string} */
        MeasureName: "height" | "bust" | "underbust" | "waist" | "hip" | "neck" | "shoulder_width" | "upper_arm" | "wrist" | "arm_length" | "thigh" | "calf" | "inseam" | "back_length";
        /** @description x, y, z in metres, y up */
        Place: [
            number,
            number,
            number
        ];
        BodyPart: components["schemas"]["body_part"];
        BoxSide: components["schemas"]["box_side"];
        Fabric: components["schemas"]["fabric.schema"];
        BodyPresets: {
            presets: {
                name: string;
                /** @enum {string} */
                sex: "female" | "male" | "child";
                measures_cm: {
                    [key: string]: number;
                };
            }[];
            measures: {
                name: components["schemas"]["MeasureName"];
                /** @description How and where it is taken */
                rule: string;
                girth: boolean;
                /** @description What a document may say at least */
                least_cm: number;
                most_cm: number;
            }[];
            /** @description What a body's file may be, in the order in which people are told */
            formats: {
                /** @description As people call it */
                name: string;
                /** @description Of the file's name */
                ending: string;
            }[];
        };
        /** @description How the body stands in its file */
        Stance: null | {
            unit_in_m: number;
            /** @enum {string} */
            up: "y" | "z";
            upside_down: boolean;
            /** @description By which it was turned to face +z */
            turned_degrees: number;
        };
        Figure: {
            /** @description Whether it is a standing person */
            stands: boolean;
            /** @description What was not found when it is none */
            why: null | {
                code: string;
                detail: string;
            };
            vertices: number;
            triangles: number;
            low: components["schemas"]["Place"];
            high: components["schemas"]["Place"];
            measures: {
                name: components["schemas"]["MeasureName"];
                girth: boolean;
                /** @description As the tape takes it */
                cm: number;
                /** @description Above the floor */
                at_cm: number;
                asked_cm: number | null;
                rule: string;
                /** @description Where the tape lies; that of a girth closes by itself */
                line: components["schemas"]["Place"][];
            }[];
            landmarks: {
                name: string;
                place: components["schemas"]["Place"];
                /** @description Present and true where the project's document sets it */
                own?: boolean;
            }[];
            boxes: {
                part: components["schemas"]["body_part"];
                centre: components["schemas"]["Place"];
                /** @description Unit vectors across, along and to the front of the part */
                axes: [
                    components["schemas"]["Place"],
                    components["schemas"]["Place"],
                    components["schemas"]["Place"]
                ];
                half: components["schemas"]["Place"];
            }[];
        };
        ProjectBody: components["schemas"]["Figure"] & {
            id: string;
            file: string | null;
            mannequin: null | components["schemas"]["mannequin"];
            friction: number;
            skin_offset_mm: number;
        };
        Finding: components["schemas"]["finding"];
        Check: {
            ready: boolean;
            findings: components["schemas"]["finding"][];
            pieces: {
                id: string;
                low: components["schemas"]["Place"];
                high: components["schemas"]["Place"];
                /** @description Where a hand put it, as POST /api/v1/projects/{id}/place took it */
                by_hand: null | components["schemas"]["PieceStand"];
                /**
                 * @description Where it stands, as POST /api/v1/projects/{id}/place would be told: by_hand where a hand put it, else the
                 *     nearest that can be said. Null where no body stands.
                 */
                stands: null | components["schemas"]["PieceStand"];
            }[];
        };
        PieceStand: {
            part: components["schemas"]["body_part"];
            side: components["schemas"]["box_side"];
            at_mm: [
                number,
                number
            ];
            away_mm: number;
            turn: number;
            wrapped: boolean;
            flipped: boolean;
        };
        Arrangement: {
            pieces: {
                id: string;
                /** @description In words */
                place: string;
            }[];
            holds: string[];
            findings: components["schemas"]["finding"][];
        };
        /** @description File name in the document → id of an asset */
        Files: {
            [key: string]: string;
        };
        Document: components["schemas"]["project.schema"];
        ProjectFields: {
            id: string;
            name: string;
            revision: number;
            created_ms: number;
            updated_ms: number;
            files: components["schemas"]["Files"];
        };
        ProjectSummary: components["schemas"]["ProjectFields"];
        Project: components["schemas"]["ProjectFields"] & {
            document: components["schemas"]["project.schema"];
        };
        EditList: components["schemas"]["edit.schema"];
        EditStep: {
            /** @description rises with every step */
            number: number;
            undone: boolean;
            created_ms: number;
            edits: components["schemas"]["edit.schema"];
        };
        /**
         * @description What layers of a DXF stand for, by their names in the file, instead of what their numbers (AAMA, ASTM) and names
         *     say. Each must be in the file. ignore: what is drawn there is not read.
         */
        LayerMap: {
            [key: string]: "cut" | "sew" | "internal" | "cutout" | "mirror" | "grain" | "notch" | "drill" | "turn" | "curve" | "ignore";
        };
        Layer: {
            name: string;
            /**
             * @description shape: no layer says what it is, so closed lines are pieces and holes by how they lie; other: its lines are lines
             *     within pieces; repeat: it repeats another layer
             * @enum {unknown}
             */
            read_as: "cut" | "sew" | "internal" | "cutout" | "mirror" | "grain" | "notch" | "drill" | "turn" | "curve" | "ignore" | "grade" | "guide" | "text" | "repeat" | "other" | "shape";
            /** @description the request says so */
            given: boolean;
            /** @description entities on it, all sizes */
            count: number;
            kinds: {
                /** @example POLYLINE */
                type: string;
                count: number;
            }[];
        };
        Import: {
            asset: string;
            /** @description name of the asset, and in `document` */
            file: string;
            /** @description null when no piece can be cut */
            document: components["schemas"]["project.schema"] | null;
            unit: {
                name: string;
                /** @description of a DXF */
                mm_per_unit?: number;
                confidence: number;
                evidence: string[];
                /** @description Where a unit that was asked for is hardly meant: no garment has pieces of that size, and in the unit that the file itself speaks for it would be one */
                doubt?: {
                    /** @example mm */
                    own: string;
                    /** @description the largest piece, in the unit that was asked for */
                    largest_mm: number;
                    /** @description likewise, in the file's own */
                    largest_own_mm: number;
                };
            };
            style: string;
            /** @description of a graded file */
            sizes: string[];
            /** @description the one that was taken */
            size: string;
            sample_size: string;
            /** @description of a DXF, those with numbers first */
            layers: components["schemas"]["Layer"][];
            pieces: components["schemas"]["ImportedPiece"][];
            /** @description Proposals, surest first, between pieces by the names that they have as often as they are cut */
            seams: components["schemas"]["SeamProposal"][];
            report: {
                counts: {
                    [key: string]: number;
                };
                entities: {
                    type: string;
                    layer: string;
                    block: string;
                    /** @enum {unknown} */
                    fate: "kept" | "converted" | "dropped";
                    reason: string;
                    piece: string;
                    count: number;
                    /** @description of the file */
                    lines: number[];
                }[];
                warnings: {
                    line: number;
                    piece: string;
                    at: components["schemas"]["Point"] | null;
                    text: string;
                    count: number;
                }[];
            };
        };
        SeamProposal: {
            id: string;
            confidence: number;
            /** @description a garment is best begun with it; it is sure (0.8 and above), nothing surer wants its edges (0.65), or it is likely (0.5) and of a piece that nothing surer holds on */
            to_wear: boolean;
            a: components["schemas"]["SeamSeries"];
            b: components["schemas"]["SeamSeries"];
            same_direction: boolean;
            length_a_mm: number;
            length_b_mm: number;
        };
        /**
         * @description Without its measures, and with a fault, when it cannot be cut. size, notches, holes, lines, outline, layer, line and from
         *     are those of a DXF.
         */
        ImportedPiece: {
            name: string;
            size?: string;
            /** @description without its holes */
            area_mm2?: number;
            width_mm?: number;
            height_mm?: number;
            edges?: number;
            notches?: number;
            holes?: number;
            /** @description drawn within it */
            lines?: number;
            /** @description 0 to 180 from the x axis */
            grain_deg: number | null;
            quantity: number;
            /** @description how many of them are turned over */
            mirrored: number;
            unfolded: boolean;
            /** @enum {unknown} */
            outline?: "sew" | "cut";
            layer?: string;
            /** @description of the file */
            line?: number;
            category?: string;
            material?: string;
            annotation?: string;
            edge_list?: {
                id: string;
                points: components["schemas"]["Polyline"];
                length_mm: number;
                start: components["schemas"]["Point"];
                end: components["schemas"]["Point"];
                curves: number;
            }[];
            notch_list?: {
                at: components["schemas"]["Point"];
                depth_mm: number;
                angle_deg: number | null;
            }[];
            /** @description Lines drawn within the piece, by the ids that they have as its lines */
            line_list?: {
                id: string;
                points: components["schemas"]["Polyline"];
            }[];
            fault?: {
                code: string;
                message: string;
                where: string;
            };
            /** @description The piece as a project document takes it */
            from?: components["schemas"]["dxf"];
            points: components["schemas"]["Polyline"];
            hole_points: components["schemas"]["Polyline"][];
        };
        Point: [
            number,
            number
        ];
        Polyline: components["schemas"]["Point"][];
        /**
         * @description A size of paper
         * @default a4
         * @enum {string}
         */
        Paper: "a4" | "a3" | "a0" | "letter";
        Pieces: {
            /**
             * @description the method that drapes them
             * @enum {string}
             */
            solver?: "toile" | "paper";
            /** @description s of simulated time after which a drape that has not settled ends */
            max_time_s?: number;
            pieces: {
                id: string;
                fabric: string;
                /** @description linear RGB */
                colour: [
                    number,
                    number,
                    number
                ];
                grain: components["schemas"]["Point"];
                texture: components["schemas"]["PieceTexture"];
                outline: components["schemas"]["Polyline"];
                holes: components["schemas"]["Polyline"][];
                edges: {
                    id: string;
                    points: components["schemas"]["Polyline"];
                    /** @description Cubic Béziers, by their four control points */
                    curves: [
                        components["schemas"]["Point"],
                        components["schemas"]["Point"],
                        components["schemas"]["Point"],
                        components["schemas"]["Point"]
                    ][];
                    length_mm: number;
                    /** @description 0 is the outline, 1 the first hole */
                    loop: number;
                }[];
                notches: {
                    at: components["schemas"]["Point"];
                    /** @description 0 when it is not told */
                    depth_mm: number;
                    inwards: components["schemas"]["Point"] | null;
                }[];
                lines: {
                    id: string;
                    points: components["schemas"]["Polyline"];
                    /** @description only drawn; the mesh takes no notice of it */
                    drawn: boolean;
                }[];
            }[];
            seams: {
                id: string;
                a: components["schemas"]["SeamSeries"];
                b: components["schemas"]["SeamSeries"];
                same_direction: boolean;
                length_a_mm: number;
                length_b_mm: number;
                /** @description What may be wrong with it */
                issues: {
                    code: string;
                    /** @description otherwise a warning: it can be sewn, but is hardly meant */
                    error: boolean;
                    message: string;
                    where: string;
                }[];
            }[];
        };
        SeamSeries: {
            piece: string;
            edge: string;
            reversed: boolean;
            from?: number;
            to?: number;
        }[];
        /** @enum {unknown} */
        JobState: "queued" | "running" | "paused" | "succeeded" | "failed" | "cancelled";
        Progress: components["schemas"]["ProgressFields"];
        ProgressFields: {
            state: components["schemas"]["JobState"];
            /** @description queued, mesh, place, dress, sew, drape, check, stills; what the drape does */
            phase: string;
            /** @description of the phase */
            fraction: number;
            /** @description substeps */
            step: number;
            simulated_s: number;
            /** @description m/s */
            rms_speed: number;
            /** @description widest open seam */
            seam_gap_mm: number;
            /** @description crossings at the last frame that was checked */
            cloth_body: number;
            cloth_cloth: number;
            /** @description wall time of a substep */
            step_ms: number;
            /** @description hands that hold the cloth just now */
            pulls: number;
            /** @description Points of the cloth that are pinned, in the order in which they were set */
            pins: components["schemas"]["LivePin"][];
        };
        LivePin: {
            /** @description Its number */
            pin: number;
            /** @description m; where it holds the cloth */
            place: [
                number,
                number,
                number
            ];
        };
        /** @enum {string} */
        FinalState: "succeeded" | "failed" | "cancelled";
        Webhook: {
            id: string;
            url: string;
            states: components["schemas"]["FinalState"][];
            label: string;
            created_ms: number;
        };
        Delivery: {
            /** @description Its number */
            delivery: number;
            /** @description Number of the event, as the feed has it; 0 of a ping */
            event: number;
            /** @description Empty of a ping */
            job: string;
            /** @enum {string} */
            state: "succeeded" | "failed" | "cancelled" | "ping";
            at_ms: number;
            /** @enum {string} */
            outcome: "waiting" | "delivered" | "given_up";
            attempts: number;
            /** @description When it is told again; 0 when it is not any more */
            next_ms: number;
            /** @description Of the last answer; 0 where there was none */
            status: number;
            /** @description What was wrong the last time */
            error: string;
        };
        /** @description Who wears the garment in a row of a sweep. A text is the name of a mannequin's preset; an object without anything is the project's own body */
        SweepBody: string | {
            /** @description What the row is called; its preset, file or project where it is not there */
            label?: string;
            /** @description Project of the same garment in another size, in place of the one that is swept */
            project_id?: string;
            mannequin?: components["schemas"]["mannequin"];
            /** @description Id of an uploaded body; not beside a mannequin */
            asset?: string;
            /**
             * @description Of the file
             * @enum {string}
             */
            unit?: "m" | "cm" | "mm";
            /**
             * @description Which axis of the file points upwards
             * @enum {string}
             */
            up?: "y" | "z";
            /** @description Degrees about the upright axis */
            turn?: number;
        };
        /** @description What the garment is cut of in a column of a sweep. A text is a fabric's name in the library, or its id in the document; an object without anything is as the project is cut */
        SweepFabric: string | {
            /** @description What the column is called; the fabric's name where it is not there */
            label?: string;
            fabric?: string;
        };
        /** @description The sweep that a job was made for, and where it stands there; null where it was asked for by itself */
        CellOfSweep: null | {
            id: string;
            /** @description Which of its bodies, from 0 */
            body: number;
            /** @description Which of its fabrics, from 0 */
            fabric: number;
        };
        SweepFields: {
            id: string;
            project_id: string;
            project_revision: number;
            name: string;
            created_ms: number;
            /** @description Whether all of its drapes have ended */
            ended: boolean;
            /** @description Of its work, its cells counting alike */
            fraction: number;
            /** @description What its rows are called */
            bodies: string[];
            /** @description And its columns */
            fabrics: string[];
            /** @description How many cells stand at each state */
            counts: {
                queued: number;
                running: number;
                paused: number;
                succeeded: number;
                failed: number;
                cancelled: number;
                removed: number;
            };
        };
        SweepSummary: components["schemas"]["SweepFields"];
        Sweep: components["schemas"]["SweepFields"] & {
            /** @description Body by body, each with all fabrics */
            cells: components["schemas"]["SweepCell"][];
        };
        SweepCell: {
            body: string;
            fabric: string;
            /** @description Id of its drape, the newest where it was tried again; null once it was removed */
            job: string | null;
            state: components["schemas"]["JobState"] | "removed";
            reason_code: string;
            reason: string;
            fraction: number;
            /** @description Whether its drape has a still from the front */
            pictured: boolean;
            figures: components["schemas"]["SweepFigures"] | null;
        };
        /** @description What of its report stands in the table */
        SweepFigures: {
            settled: boolean;
            stop_reason: string;
            /**
             * @description Null where nobody stands there and where cloth without seams stays on the body
             * @enum {unknown}
             */
            worn: "yes" | "partly" | "no" | null;
            bust: components["schemas"]["SweepEase"];
            waist: components["schemas"]["SweepEase"];
            hip: components["schemas"]["SweepEase"];
            /** @description Tension along the warp as a ratio; 99 % of the triangles have less */
            warp_p99: number;
            weft_p99: number;
            /** @description rad */
            shear_p99: number;
            /** @description Crossings at the end */
            cloth_body: number;
            cloth_cloth: number;
            /** @description Crossings in the worst frame */
            worst_body: number;
            worst_cloth: number;
            open_seams: number;
            cpu_s: number;
            simulated_s: number;
            particles: number;
            /** @description Of the final positions */
            hash: string;
        };
        /** @description Null where the garment does not go around */
        SweepEase: null | {
            /** @enum {unknown} */
            fit: "fits" | "stretched" | "too_tight";
            /** @description Garment less body */
            ease_mm: number;
        };
        Version: {
            id: string;
            name: string;
            /** @description of the project when it was named */
            revision: number;
            created_ms: number;
            /** @description Whether the project stands as it did */
            current: boolean;
            /** @description Drapes of this very state, newest first; those after a return to it too */
            jobs: string[];
        };
        JobEvent: {
            /** @description Its id; empty where a sweep itself has ended or is gone */
            job: string;
            /** @description Id of the sweep that it is of; empty where it is of none */
            sweep: string;
            project_id: string;
            name: string;
            /** @description Its new state, or that it is gone */
            state: components["schemas"]["JobState"] | "removed";
            /** @description Of a state that is final; else empty */
            reason_code: string;
            at_ms: number;
        };
        /**
         * @description Whether somebody looks on. Drapes are worked on in slices: an interactive one goes before batch work, and users share
         *     the workers' time alike.
         * @default batch
         * @enum {unknown}
         */
        JobPriority: "interactive" | "batch";
        JobFields: {
            /** @description of a link where the job is seen by one */
            id: string;
            project_id: string;
            /** @description 0 where the job is seen by a link */
            project_revision: number;
            name: string;
            priority: components["schemas"]["JobPriority"];
            /** @description Whether they are drawn of its end */
            pictures?: boolean;
            state: components["schemas"]["JobState"];
            /** @description of a job that has ended: "settled", "time", "start.crosses_body" */
            reason_code: string;
            /** @description a sentence for a person */
            reason: string;
            reason_where: string;
            /** @description What the end fell short of although it ended well; the reason says the same in words */
            notes: {
                /** @description stills.not_drawn, stills.not_kept, pictures.not_read */
                code: string;
                message: string;
            }[];
            /** @description starts that nothing is known to have come of */
            attempt: number;
            created_ms: number;
            started_ms: number;
            ended_ms: number;
            /** @description Processor time that it took, over all its starts, without that of its pictures */
            worked_s: number;
            /** @description File name → bytes */
            results: {
                [key: string]: number;
            };
        };
        /** @description null once the job has ended */
        ProgressNow: components["schemas"]["Progress"] | null;
        /** @description What its owner calls it; for nobody who sees it by a link */
        Tags: string[];
        /**
         * @example {
         *       "tags": [
         *         "spring"
         *       ],
         *       "sweep": null,
         *       "id": "j_1qedqq1nd5hfbjxpm78j",
         *       "project_id": "p_1qedqq1nd5hfbjxpm78j",
         *       "project_revision": 1,
         *       "name": "A-line skirt",
         *       "priority": "batch",
         *       "state": "running",
         *       "reason_code": "",
         *       "reason": "",
         *       "reason_where": "",
         *       "notes": [],
         *       "attempt": 1,
         *       "created_ms": 1795229571125,
         *       "started_ms": 1795229571300,
         *       "ended_ms": 0,
         *       "worked_s": 1.25,
         *       "results": {},
         *       "progress": {
         *         "state": "running",
         *         "phase": "drape",
         *         "fraction": 0.25,
         *         "step": 5100,
         *         "simulated_s": 1.7,
         *         "rms_speed": 0.12,
         *         "seam_gap_mm": 0,
         *         "cloth_body": 0,
         *         "cloth_cloth": 0,
         *         "step_ms": 1.9,
         *         "pulls": 0,
         *         "pins": []
         *       }
         *     }
         */
        JobSummary: components["schemas"]["JobFields"] & {
            progress: components["schemas"]["ProgressNow"];
            tags: components["schemas"]["Tags"];
            sweep: components["schemas"]["CellOfSweep"];
        };
        Job: components["schemas"]["JobFields"] & {
            progress: components["schemas"]["ProgressNow"];
            tags: components["schemas"]["Tags"];
            sweep: components["schemas"]["CellOfSweep"];
            /** @description report.json; null until there is one */
            report: components["schemas"]["report.schema"] | null;
        };
        /**
         * @description stills in full size and movies; GLB and OBJ; report.json and the report as a page
         * @enum {string}
         */
        Taking: "pictures" | "models" | "report";
        Link: {
            id: string;
            /** @description Id of what it shows */
            job: string;
            label: string;
            take: components["schemas"]["Taking"][];
            created_ms: number;
            /** @description 0 for never */
            expires_ms: number;
            expired: boolean;
        };
        /** @description A job under the id of a link to it; its project, places in the pattern and results that may not be taken are left out */
        SharedJob: components["schemas"]["JobFields"] & {
            progress: components["schemas"]["ProgressNow"];
            label: string;
            /** @description 0 for never */
            expires_ms: number;
            take: components["schemas"]["Taking"][];
            /** @description Names of the pictures */
            stills: string[];
            /** @description There is a draped cloth to show */
            cloth: boolean;
            /** @description report.json; null until there is one */
            report: components["schemas"]["report.schema"] | null;
        };
        SeenPieces: {
            pieces: {
                id: string;
                fabric: string;
                /** @description linear RGB */
                colour: [
                    number,
                    number,
                    number
                ];
                grain: components["schemas"]["Point"];
                texture: components["schemas"]["PieceTexture"];
            }[];
            fabrics: components["schemas"]["fabric.schema"][];
        };
        /** @description A picture on the piece, as the document has it; its file is among the project's */
        PieceTexture: null | {
            /** @description name of the file */
            image: string;
            /** @description width of one repeat */
            scale_mm: number;
            offset: components["schemas"]["Point"];
            /** @description degrees, counter-clockwise from the grain */
            angle: number;
        };
        /**
         * @example {
         *       "name": "turntable-480x600-25.mp4",
         *       "state": "making",
         *       "fraction": 0.4,
         *       "href": null,
         *       "error": null
         *     }
         */
        Movie: {
            /** @description of the result that it is or becomes */
            name: string;
            /** @enum {string} */
            state: "queued" | "making" | "made" | "failed";
            /** @description of its making */
            fraction: number;
            /** @description once it is made */
            href: string | null;
            /** @description why it failed, e.g. movie.no_ffmpeg, movie.too_large */
            error: {
                code: string;
                detail: string;
            } | null;
        };
        /**
         * @example {
         *       "name": "still-front-ease-800x1000.png",
         *       "state": "making",
         *       "fraction": 0,
         *       "href": null,
         *       "error": null
         *     }
         */
        Still: {
            /** @description of the result that it is or becomes */
            name: string;
            /** @enum {string} */
            state: "queued" | "making" | "made" | "failed";
            /** @description of its making */
            fraction: number;
            /** @description once it is taken */
            href: string | null;
            /** @description why it failed, e.g. map.absent, render.too_far */
            error: {
                code: string;
                detail: string;
            } | null;
        };
        /**
         * @description x, y, z in metres: y up, the ground at 0, the body faces +z
         * @example [
         *       0.4,
         *       1.2,
         *       2.5
         *     ]
         */
        ScenePoint: [
            number,
            number,
            number
        ];
        /**
         * @example {
         *       "name": "final.glb",
         *       "size": 271244,
         *       "xxh3": "185b51bfe69fa48fcfaabd3c3951412c",
         *       "content_type": "model/gltf-binary",
         *       "href": "/api/v1/jobs/j_1qedqq1nd5hfbjxpm78j/results/final.glb"
         *     }
         */
        ResultFile: {
            name: string;
            /** @description bytes */
            size: number;
            /** @description 128-bit XXH3 of its bytes, which is looked at before it is sent; empty for results of before it was kept */
            xxh3: string;
            content_type: string;
            href: string;
        };
        text: string;
        /** @description A point of a curve of tension over strain, which begins at 0, 0. */
        curve_point: {
            /** @description %; more than at the point before. */
            strain_percent: number;
            /** @description N/m; more than at the point before. */
            tension_n_m: number;
        };
        /** @description Where figures come from. */
        figure_source: {
            /** @description Their keys; every figure of the file stands in one such list. */
            of: components["schemas"]["text"][];
            /** @description Who measured them, and when. */
            source?: components["schemas"]["text"];
            /** @description What they are estimated from: nobody measured them. */
            estimated_from?: components["schemas"]["text"];
        } & (unknown | unknown);
        /**
         * Toile fabric
         * @description A fabric of the library: what it is, its figures, and where each of them comes from.
         */
        "fabric.schema": {
            /** @description Version of this format. */
            toile_fabric: number;
            /** @description As documents name it: small letters, digits and hyphens; the file's own name. */
            name: components["schemas"]["text"];
            /** @description What people call it. */
            title: components["schemas"]["text"];
            /** @description What it is spun of. */
            fibre: components["schemas"]["text"];
            /**
             * @description How it is made.
             * @enum {string}
             */
            construction: "woven" | "knit" | "nonwoven" | "net" | "leather";
            /** @description How its threads run, for the look. */
            weave: components["schemas"]["text"];
            /** @description What is sewn of it. */
            use?: components["schemas"]["text"];
            /** @description g/m². */
            areal_mass_g_m2: number;
            /** @description mm; also the distance that layers keep. */
            thickness_mm: number;
            /** @description µN·m; bending rigidity per width of a strip cut along the warp. */
            bend_warp_un_m: number;
            /** @description µN·m; of a strip cut along the weft. */
            bend_weft_un_m: number;
            /** @description µN·m; of a strip cut at 45°. */
            bend_bias_un_m: number;
            /** @description Tension over strain along the warp, or along a knit's wales. The solver takes the slope of the first part, and as its limit the strain where that line meets the line of the last part. */
            stretch_warp: components["schemas"]["curve_point"][];
            /** @description The same along the weft, or along a knit's courses. */
            stretch_weft: components["schemas"]["curve_point"][];
            /** @description N/m; tension along one per strain along the other at small strain; its square is less than the product of both first stiffnesses. */
            stretch_coupling_n_m: number;
            /** @description N/m per radian of shear. */
            stretch_shear_n_m: number;
            /** @description Radians of shear beyond which the cloth is much stiffer. 0: never. */
            limit_shear_rad: number;
            /** @description Coulomb's coefficient, cloth on cloth. */
            friction: number;
            /** @description %; where the drape coefficient of such fabrics (30 cm on 18 cm) begins, where that is published. */
            drape_least_percent?: number;
            /** @description %; and where it ends. */
            drape_most_percent?: number;
            /** @description Linear red, green and blue for pictures, 0 to 1. */
            colour: [
                number,
                number,
                number
            ];
            /** @description Where the figures come from; each of them stands in one. */
            sources: components["schemas"]["figure_source"][];
        };
        /** @description A standing figure made from measures. */
        mannequin: {
            /** @description Of a size table: "eu34" to "eu48", "m44" to "m58", "child92" to "child170". Its sex and measures hold where no other stand here. */
            preset?: components["schemas"]["text"];
            /**
             * @description Default: the preset's, or female. With neither preset nor sex, height, bust, waist and hip are 170, 90, 72 and 96 where they are not given; else what is not given follows from proportions.
             * @enum {string}
             */
            sex?: "female" | "male" | "child";
            /**
             * @description a: the arms hang at an angle (default); t: they stand out level.
             * @enum {string}
             */
            pose?: "a" | "t";
            /** @description Degrees between a hanging arm and the arm in pose a. Default 45. */
            arm_angle?: number;
            /** @description cm, from the floor to the top of the head. */
            height_cm?: number;
            /** @description cm; a woman's bust at the bust points, a chest at its widest below the armpits. */
            bust_cm?: number;
            /** @description cm around the ribs below the breasts. */
            underbust_cm?: number;
            /** @description cm around the narrowest place. */
            waist_cm?: number;
            /** @description cm around the widest place. */
            hip_cm?: number;
            /** @description cm around the narrowest place of the neck. */
            neck_cm?: number;
            /** @description cm from shoulder point to shoulder point, straight. */
            shoulder_width_cm?: number;
            /** @description cm around the upper arm. */
            upper_arm_cm?: number;
            /** @description cm around the narrowest place of the wrist. */
            wrist_cm?: number;
            /** @description cm from the shoulder point over the elbow to the wrist. */
            arm_length_cm?: number;
            /** @description cm around the thigh, right below the crotch. */
            thigh_cm?: number;
            /** @description cm around the widest place of the calf. */
            calf_cm?: number;
            /** @description cm from the crotch to the floor. */
            inseam_cm?: number;
            /** @description cm from the nape to the waist, along the back. */
            back_length_cm?: number;
            /** @description How many triangles the figure has. Default 3300. */
            triangles?: number;
        };
        /**
         * @description Whose box. Default torso. Left and right are the wearer's.
         * @enum {string}
         */
        body_part: "head" | "neck" | "torso" | "hips" | "left_arm" | "right_arm" | "left_leg" | "right_leg";
        /** @description A file in the document's folder or below it, with '/' between folders. Absolute paths and '..' are refused. */
        file: string;
        coordinate: number;
        /** @description Two numbers, x and y (or x and z where the key says so). */
        pair: [
            components["schemas"]["coordinate"],
            components["schemas"]["coordinate"]
        ];
        /** @description A piece in a DXF file. */
        dxf: {
            dxf: components["schemas"]["file"];
            /** @description The piece's name in the file. */
            piece: components["schemas"]["text"];
            /** @description Points (mm) of the outline where edges begin and end, instead of its sharp bends; each within 0.5 mm of the outline. */
            corners?: components["schemas"]["pair"][];
            /**
             * @description Length unit of the file, when the file does not say or says it wrong.
             * @enum {string}
             */
            units?: "mm" | "cm" | "inch";
            /** @description Size to take of a graded file, instead of its sample size. */
            size?: components["schemas"]["text"];
            /** @description What layers of the file stand for, by their names there, instead of what their numbers (AAMA) and names say. */
            layers?: {
                [key: string]: "cut" | "sew" | "internal" | "cutout" | "mirror" | "grain" | "notch" | "drill" | "turn" | "curve" | "ignore";
            };
        };
        /** @description A run of the outline between two corners: what seams and attachments name. */
        edge: {
            /** @description Unique within its piece, and stable when the outline is edited. */
            id: components["schemas"]["text"];
            /** @description The edge passes through these points, mm: smoothly where they bend gently, within 0.1 mm of each. */
            points?: components["schemas"]["pair"][];
            /** @description Cubic Béziers, each beginning where the one before it ends. */
            curves?: [
                components["schemas"]["pair"],
                components["schemas"]["pair"],
                components["schemas"]["pair"],
                components["schemas"]["pair"]
            ][];
        } & (unknown | unknown);
        /** @description A line on a piece, straight from point to point. An end at the outline joins it; elsewhere lines may meet each other only in points that both have. */
        line: {
            /** @description Unique within its piece, beside the ids of the edges. */
            id: components["schemas"]["text"];
            /** @description mm; inside the outline, or on it at the ends. */
            points: components["schemas"]["pair"][];
            /** @description Only drawn: the mesh takes no notice of it, and it may run anywhere, until an elastic or a fold lies on it. Default false. */
            drawn?: boolean;
        };
        /** @description A mark on the outline, where two pieces meet when they are sewn. */
        notch: {
            /** @description mm. */
            at: components["schemas"]["pair"];
            /** @description Of the cut into the allowance. Default 0: not told. */
            depth_mm?: number;
            /** @description Direction of the cut; its length does not matter. */
            inwards?: components["schemas"]["pair"];
        };
        /** @description A picture on the cloth, repeated over the piece; it turns with the grain. Looks alone: a drape comes out the same with it. */
        texture: {
            /** @description A PNG or JPEG file of at most 20 MiB and 64 million pixels, beside the document. */
            image: components["schemas"]["file"];
            /** @description Width of one repeat on the flat piece; its height goes by the picture's form. */
            scale_mm: number;
            /** @description mm; where a lower left corner of the picture lies. Default [0, 0]. */
            offset?: components["schemas"]["pair"];
            /** @description Degrees, counter-clockwise, from the warp to the upright of the picture. Default 0. */
            angle?: number;
        };
        /** @description What the piece has otherwise than its fabric (interlined, pressed, of another lot; keys as of a fabric), and how finely it is meshed. */
        physical: {
            /** @description Name of a fabric of the library that is fused to the piece: both masses, both stiffnesses, and as a laminate far stiffer in bending. What else stands here holds for the two together. */
            interlining?: components["schemas"]["text"];
            /** @description g/m². */
            areal_mass_g_m2?: number;
            /** @description N/m along the warp. */
            stretch_warp_n_m?: number;
            /** @description N/m along the weft. */
            stretch_weft_n_m?: number;
            /** @description N/m between warp and weft. */
            stretch_coupling_n_m?: number;
            /** @description N/m per radian of shear. */
            stretch_shear_n_m?: number;
            /** @description µN·m; bending rigidity per width of a strip cut along the warp. */
            bend_warp_un_m?: number;
            /** @description µN·m; of a strip cut along the weft. */
            bend_weft_un_m?: number;
            /** @description µN·m; of a strip cut at 45°. */
            bend_bias_un_m?: number;
            /** @description mm; also the distance that layers keep. */
            thickness_mm?: number;
            /** @description Coefficient against anything. */
            friction?: number;
            /** @description mm; wanted edge length of the piece's own triangles. On a seam the finer of both sides counts. */
            particle_distance_mm?: number;
        };
        /** @description Three numbers, x, y and z. */
        triple: [
            components["schemas"]["coordinate"],
            components["schemas"]["coordinate"],
            components["schemas"]["coordinate"]
        ];
        /**
         * @description Which side of the box. Default front. Left and right are the wearer's.
         * @enum {string}
         */
        box_side: "front" | "back" | "left" | "right";
        /** @description Where the flat piece stands before it is sewn: as a stiff sheet, or rolled around an axis; in space, or told by a part of the body. */
        placement: {
            /** @description The flat point (u, v) goes to translation + R (u, v, 0). The right side of the cloth faces R (0, 0, 1). */
            rigid?: {
                /** @description m; where the piece's origin goes. Default [0, 0, 0]. */
                translation?: components["schemas"]["triple"];
                /** @description Degrees about the fixed axes x, then y, then z. Default [0, 0, 0]. */
                rotation?: components["schemas"]["triple"];
                /** @description Mirror u first: the piece seen from its wrong side. Default false. */
                flipped?: boolean;
            };
            /** @description The piece rolled without stretching around an axis, upright unless told otherwise: u along the circle, counter-clockwise seen from above, v upwards. */
            wrapped?: {
                /** @description m; x and z of the axis. Default [0, 0]. */
                axis?: components["schemas"]["pair"];
                /** @description m, at the anchor. */
                radius: number;
                /** @description Degrees; where the anchor comes to: 0 is the front (+z), 90 is +x. Default 0. */
                angle?: components["schemas"]["coordinate"];
                /** @description m; y of the anchor. */
                height: components["schemas"]["coordinate"];
                /** @description mm; the flat point that angle and height speak of. Default [0, 0]. */
                anchor?: components["schemas"]["pair"];
                /** @description Metres by which the radius grows for each metre of cloth downwards: a cone. Default 0. */
                slope?: number;
                /** @description m; y of the axis's point, from which heights count along the axis. Default 0. */
                axis_height?: components["schemas"]["coordinate"];
                /** @description Direction of the axis; about one along z, angle 0 is +y. Default [0, 1, 0]. */
                up?: [
                    number,
                    number,
                    number
                ];
                /** @description Degrees by which the flat piece is turned about the anchor first. Default 0. */
                turn?: components["schemas"]["coordinate"];
                /** @description Mirror u about the anchor after the turn: the right side faces the axis. Default false. */
                flipped?: boolean;
            };
            /** @description A stiff sheet before a side of the box around a part of the body, along that part. It goes where the body is. */
            on_box?: {
                /** @description Id of a standing body. Default: the first one. */
                body?: components["schemas"]["text"];
                part?: components["schemas"]["body_part"];
                side?: components["schemas"]["box_side"];
                /** @description m from the side's middle: to the right as one looks at it, and up along the part. Default [0, 0]. */
                at?: components["schemas"]["pair"];
                /** @description m before the side. Default 0.03. */
                away?: number;
                /** @description Degrees, counter-clockwise as one looks at the side. Default 0. */
                turn?: components["schemas"]["coordinate"];
                /** @description mm; the flat point that comes there. Default: the middle of the piece's bounding box. */
                anchor?: components["schemas"]["pair"];
                /** @description Mirror u first: the right side faces the body. Default false. */
                flipped?: boolean;
            };
            /** @description Rolled around a part of the body, along its box, clear of all that stands out of it under the piece. */
            around?: {
                /** @description Id of a standing body. Default: the first one. */
                body?: components["schemas"]["text"];
                part?: components["schemas"]["body_part"];
                side?: components["schemas"]["box_side"];
                /** @description m from the side's middle: along the circle, and up along the part. Default [0, 0]. */
                at?: components["schemas"]["pair"];
                /** @description m from what stands out farthest. Default 0.02. */
                away?: number;
                /** @description Degrees, counter-clockwise as one looks at the side. Default 0. */
                turn?: components["schemas"]["coordinate"];
                /** @description Metres by which the radius grows for each metre of cloth downwards: a cone. Default 0. */
                slope?: number;
                /** @description mm; the flat point that comes there. Default: the middle of the piece's bounding box. */
                anchor?: components["schemas"]["pair"];
                /** @description Mirror u first: the right side faces the body. Default false. */
                flipped?: boolean;
            };
        } & (unknown | unknown | unknown | unknown);
        /** @description Coefficients from 0 to 1 in place of figures; figures that stand here go before them. */
        coefficients: {
            /** @description Largest strain along the warp: 0.05 is 5 %; 1 is soft. The stiffness becomes 60 N/m over it. */
            elasticity_warp?: number;
            /** @description The same along the weft. */
            elasticity_weft?: number;
            /** @description Bending length (B / w)^(1/3) along the warp over 50 mm, w the weight per area: 0 is limp, 1 stiff. Of the bias, where both stand here: the radius at 45° of the ellipse with these half axes. */
            bending_warp?: number;
            /** @description The same along the weft. */
            bending_weft?: number;
        };
        /** @description An edge of a piece, or a part of one. */
        seam_edge: {
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges. */
            edge: components["schemas"]["text"];
            /** @description Traversed against the outline's own direction. Default false. */
            reversed?: boolean;
            /** @description Where the sewn part begins: a fraction of the edge's length, in the outline's own direction. Default 0. */
            from?: number;
            /** @description Where it ends. Default 1. */
            to?: number;
        };
        /** @description A named place on a body, beside those that every standing body has, or in place of the one of that name: a point of a triangle of a mesh file, or told from another landmark (for a mannequin always: its triangles change with its measures). */
        landmark: {
            /** @description Unlike those of the other landmarks here. */
            name: components["schemas"]["text"];
            /** @description Of the mesh as it is read, counted from 0. */
            triangle?: number;
            /** @description Of the triangle's three corners, summing to 1. Default: its middle. */
            share?: [
                number,
                number,
                number
            ];
            /** @description Name of a landmark of this body that stands before it; of one that is moved, its own. */
            near?: components["schemas"]["text"];
            /** @description mm from that one; the skin nearest to there is meant. Default [0, 0, 0]. */
            offset_mm?: [
                number,
                number,
                number
            ];
            /** @description mm; the body's height when the offset was told. On a taller body it is longer in proportion. Default: it stays. */
            body_height_mm?: number;
        } & (unknown | unknown);
        /** @description A shape that a body comes to while the cloth hangs on it: another pose or size of its mesh, with the same vertices and triangles in the same order. */
        keyframe: {
            /** @description s after the body begins to move; later than the keyframe before it. Default 1. */
            after_s?: number;
            /** @description Read and placed as the body's own. */
            file?: components["schemas"]["file"];
            mannequin?: components["schemas"]["mannequin"];
        } & (unknown | unknown);
        /** @description A place to which cloth is led while the seams close. Contact is stronger than the hold: what is in the way makes it wait. */
        goal: {
            /** @description Id of a body. Default: the first that stands, or that bears the landmark. */
            body?: components["schemas"]["text"];
            /** @description Name of a landmark, e.g. neck_front, waist_left, or one of the body's own. Points go there; of edges their middle. */
            landmark?: components["schemas"]["text"];
            /** @description A line around the body, as a tape lies: neck, neckline, bust, underbust, waist, high_hip, hip, and with _left or _right upper_arm, elbow, wrist, thigh, knee, ankle. Points and whole edges come to lie on it, and may slide along it. */
            line?: components["schemas"]["text"];
            /** @description m; a fixed place in space. Points go there; of edges their middle. */
            place?: components["schemas"]["triple"];
            /** @description mm by which a line is shifted up, along limbs towards the trunk. Default 0. */
            up_mm?: number;
        } & (unknown | unknown | unknown);
        /** @description A point of a flat piece. */
        button_point: {
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description mm; on the piece. */
            at: components["schemas"]["pair"];
        };
        /** @description What the method of Kim and Park 2003 leaves to its user (docs/paper.md). What is absent is the best that a search over samples found. */
        paper: {
            /** @description s; one step of its integrator. */
            time_step_s?: number;
            /** @description Share of its way that a particle loses with each step. */
            damping?: number;
            /** @description Over all links, seams and held particles, a step. */
            passes?: number;
            /** @description Share of its way that a particle keeps, mirrored, where it strikes a surface. */
            reflection?: number;
            /** @description N/m; a link's largest elastic strain is what its fabric is stretched by under this load, its limit at most. 490 gives the fabric's coefficients. */
            load_n_m?: number;
            /** @description mm; bodies are met so far outside their skin at least, since of a link only the ends are tried. */
            clearance_mm?: number;
        };
        /** @description Air that resists the cloth, by the speed between them. */
        air: {
            /** @description kg/m³. Default 1.2. */
            density_kg_m3?: number;
            /** @description Drag coefficient of cloth that moves face-on. Default 1.2. */
            drag_across?: number;
            /** @description Of cloth that slides in its own plane. Default 0.05. */
            drag_along?: number;
            /** @description m/s; the air's own speed. Default [0, 0, 0]. */
            wind_m_s?: [
                number,
                number,
                number
            ];
        };
        /** @description One piece of cloth. Its outline stands here or in a DXF file. */
        piece: {
            /** @description Name that seams and attachments use. */
            id: components["schemas"]["text"];
            from?: components["schemas"]["dxf"];
            /** @description The edges one after the other, counter-clockwise with y up (a clockwise one is run the other way); each begins where the one before it ends, the first where the last ends, to 0.01 mm. */
            outline?: components["schemas"]["edge"][];
            /** @description Closed lines inside the outline, run clockwise. Only beside an inline outline. */
            holes?: components["schemas"]["edge"][][];
            /** @description Other ids for the edges of a piece from a file, e.g. {"e0": "waist"}. `toile check` lists the ids. */
            edge_names?: {
                [key: string]: components["schemas"]["text"];
            };
            /** @description Direction of the warp in the flat piece; its length does not matter. Without it, the file's grain line, or [0, 1]. */
            grain?: components["schemas"]["pair"];
            /** @description Id of a fabric of this document, or the name of one of the library (`toile fabric list`). Default: the project's. */
            fabric?: components["schemas"]["text"];
            /** @description Lines on the piece, beside those that stand in its file. Edges of the mesh lie on those that are not only drawn. */
            lines?: components["schemas"]["line"][];
            /** @description Order outwards: a piece of a higher layer is worn over those of lower ones. Default 0. */
            layer?: number;
            /** @description Marks on the outline. Only beside an inline outline; those of a file stand there. */
            notches?: components["schemas"]["notch"][];
            texture?: components["schemas"]["texture"];
            physical?: components["schemas"]["physical"];
            placement: components["schemas"]["placement"];
        } & (unknown | unknown);
        /** @description A fabric in measured units: figures of its own, or those of a fabric of the library where it has none. */
        fabric: {
            /** @description Name that pieces use. */
            id: components["schemas"]["text"];
            /** @description What people call the fabric. */
            name?: components["schemas"]["text"];
            /** @description Name of a fabric of the library (`toile fabric list`): it has the figures that do not stand here. */
            like?: components["schemas"]["text"];
            coefficients?: components["schemas"]["coefficients"];
            /** @description g/m². */
            areal_mass_g_m2?: number;
            /** @description N/m; tension per strain along the warp. */
            stretch_warp_n_m?: number;
            /** @description N/m; tension per strain along the weft. */
            stretch_weft_n_m?: number;
            /** @description N/m; tension along one per strain along the other; its square is less than warp times weft. Default 600. */
            stretch_coupling_n_m?: number;
            /** @description N/m per radian of shear. */
            stretch_shear_n_m?: number;
            /** @description %; strain along the warp beyond which the cloth is much stiffer. 0, the default: never. */
            limit_warp_percent?: number;
            /** @description %; the same along the weft. */
            limit_weft_percent?: number;
            /** @description Radians; the same for shear. */
            limit_shear_rad?: number;
            /** @description µN·m; bending rigidity per width of a strip cut along the warp. */
            bend_warp_un_m?: number;
            /** @description µN·m; of a strip cut along the weft. */
            bend_weft_un_m?: number;
            /** @description µN·m; of a strip cut at 45°. */
            bend_bias_un_m?: number;
            /** @description mm; also the distance that layers keep. */
            thickness_mm?: number;
            /** @description Coulomb's coefficient, cloth on cloth. Default 0.3. */
            friction?: number;
            /** @description Linear red, green and blue for pictures, 0 to 1. */
            colour?: [
                number,
                number,
                number
            ];
        } | unknown | unknown;
        /** @description Sews the path that series a makes to the path that series b makes. Two outlines that both run counter-clockwise meet with their edges against each other: the start of a meets the end of b. */
        seam: {
            /** @description Name that messages use. */
            id: components["schemas"]["text"];
            /** @description Edges in the order in which they are sewn. */
            a: components["schemas"]["seam_edge"][];
            /** @description Edges in the order in which they are sewn. */
            b: components["schemas"]["seam_edge"][];
            /** @description The start of a meets the start of b. Default false. */
            same_direction?: boolean;
        };
        /** @description Something solid that cloth meets, a person as well as a table or a cushion: a mesh from a file, or the program's own mannequin. There may be several. */
        body: {
            /** @description Name that messages use. */
            id: components["schemas"]["text"];
            file?: components["schemas"]["file"];
            /**
             * @description Length unit of the file. Without it, the mesh's size decides.
             * @enum {string}
             */
            unit?: "m" | "cm" | "mm";
            /**
             * @description Which axis of the file points upwards. Default y.
             * @enum {string}
             */
            up?: "y" | "z";
            mannequin?: components["schemas"]["mannequin"];
            /** @description Coulomb's coefficient, cloth on this body. Default 0.4. */
            friction?: number;
            /** @description mm; distance that cloth keeps from the skin. Default 1. */
            skin_offset_mm?: number;
            /** @description Reflection coefficient: the share of its speed towards the skin that cloth keeps, turned round, when it strikes. 0: none (default); 1: all. */
            restitution?: number;
            /** @description m; applied last. Default [0, 0, 0]. */
            translation?: components["schemas"]["triple"];
            /** @description Degrees about the fixed axes x, then y, then z; applied after the scale. Default [0, 0, 0]. */
            rotation?: components["schemas"]["triple"];
            /** @description Applied first. Default 1. */
            scale?: number;
            /** @description Named places on it, beside those that the program finds. */
            landmarks?: components["schemas"]["landmark"][];
            /** @description How it moves once the cloth hangs on it: straight from each of these shapes to the next. It waits where the cloth cannot give way. The cloth then comes to rest anew. */
            motion?: components["schemas"]["keyframe"][];
        } & (unknown | unknown);
        /** @description Holds part of a piece, e.g. a waistband at its height until friction carries it, or leads it to a place on the body. */
        attachment: {
            /** @description Name that messages use. */
            id?: components["schemas"]["text"];
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Ids of its edges; neither edges nor points: the whole piece. */
            edges?: components["schemas"]["text"][];
            /** @description mm; points of the flat piece. */
            points?: components["schemas"]["pair"][];
            /**
             * @description height: keeps its height and may move sideways (default); place: does not move. Not beside to.
             * @enum {string}
             */
            hold?: "height" | "place";
            to?: components["schemas"]["goal"];
            /** @description s after gravity has come to its full strength; negative: never. Default 1. */
            release_after_s?: number;
        };
        /** @description A short thread from a point of a piece to another point. Cloth and body between are stronger than it. */
        button: {
            /** @description Name that messages use. */
            id: components["schemas"]["text"];
            /** @description One end. */
            a: components["schemas"]["button_point"];
            /** @description The other end. */
            b: components["schemas"]["button_point"];
            /** @description mm; the thread's length once it is closed. Default 2. */
            distance_mm?: number;
        };
        /** @description A band that pulls with stiffness times strain where it is longer than its own length, and never pushes. */
        elastic: {
            /** @description Name that messages use. */
            id: components["schemas"]["text"];
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Ids of edges or lines of the piece. */
            lines: components["schemas"]["text"][];
            /** @description Length of the band without load, per length of the flat cloth: under 1 it gathers. Default 1. */
            factor?: number;
            /** @description N; tension per strain of the band. Default 20. */
            stiffness_n?: number;
        };
        /** @description Presses the cloth to an angle along lines or seams. */
        fold: {
            /** @description Name that messages use. */
            id: components["schemas"]["text"];
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Ids of lines of the piece, or of edges along which it is pressed to what they are sewn to. */
            lines: components["schemas"]["text"][];
            /** @description Degrees from flat: 180 folds the piece onto itself with the side outside that is up in the flat piece, -180 with that side inside. */
            angle: number;
            /** @description mN·m per radian and metre of line. The cloth's own bending holds against it. Default 20. */
            stiffness_mn?: number;
        };
        /** @description Pieces that hold air. Openings that seams leave count as closed by a lid. */
        cushion: {
            /** @description Name that messages use. */
            id: components["schemas"]["text"];
            /** @description Ids of pieces. The side of the first that is up in the flat piece is the outside. */
            pieces: components["schemas"]["text"][];
            /** @description Pa above the air outside; negative sucks. Default 100. */
            pressure_pa?: number;
            /** @description l; the amount of air is fixed, and has that pressure at this volume (pressure times volume stays the same). 0, the default: pumped at constant pressure. */
            volume_l?: number;
        };
        /** @description How to drape. Every key has a default that suits a garment. */
        settings: {
            /**
             * @description toile: the engine that lets nothing through (default); paper: the method of Kim and Park 2003, to compare with, whose crossings are counted and told. It takes gravity, sew_time_s, settle_speed_mm_s, max_time_s, start, ground and end from here, and its time step from paper.
             * @enum {string}
             */
            solver?: "toile" | "paper";
            /** @description mm; wanted edge length of the triangles. Default 15. */
            particle_distance_mm?: number;
            /** @description s; one substep of the solver. Default 1/3000. */
            time_step_s?: number;
            /** @description m/s², downwards. Default 9.81. */
            gravity?: number;
            /** @description s in which the seams close, without gravity. Default 1. */
            sew_time_s?: number;
            /** @description mm/s; root mean square speed under which the cloth counts as at rest. Default 5. */
            settle_speed_mm_s?: number;
            /** @description s of simulated time after which a drape that has not settled ends. Default 15. */
            max_time_s?: number;
            /** @description Substeps between frames that viewers see, at most. Default 50. */
            frame_interval_steps?: number;
            /**
             * @description auto: the garment is put on the body first, where that can be certified (default); sewn: the pieces are sewn together from where they stand.
             * @enum {string}
             */
            start?: "auto" | "sewn";
            /** @description Whether a person stands on ground that cloth lies on. Default true. */
            ground?: boolean;
            /**
             * @description drape: only the end matters, and added damping brings the cloth to rest (default); dynamic: true time once the garment is sewn, slowed by air and friction only.
             * @enum {string}
             */
            mode?: "drape" | "dynamic";
            /**
             * @description settled: when the cloth is at rest, at max_time_s at the latest; time: at max_time_s. Default settled in mode drape, time in mode dynamic.
             * @enum {string}
             */
            end?: "settled" | "time";
            /** @description Of solver paper. Without it: its defaults. */
            paper?: components["schemas"]["paper"];
            /** @description The air around the cloth. Without it: still air in mode dynamic, none in mode drape. */
            air?: components["schemas"]["air"];
        };
        /**
         * Toile project
         * @description A garment to drape: flat pieces, what they are made of, how they are sewn, what they hang on. Millimetres in the pattern, metres in space (y up, right-handed, the body looks along +z), degrees for angles. A document has at most 4 MiB and nests at most 32 levels deep.
         */
        "project.schema": {
            /** @description Version of this format. */
            toile: number;
            /** @description What people call the project. */
            name?: components["schemas"]["text"];
            /** @description The pieces of cloth, as they are cut. Their ids are unique. */
            pieces: components["schemas"]["piece"][];
            /** @description What the pieces are made of that name no fabric: the id of one of this document, or the name of one of the library (`toile fabric list`). */
            fabric?: components["schemas"]["text"];
            /** @description Fabrics with figures of their own, for the pieces to name. Their ids are unique. */
            fabrics?: components["schemas"]["fabric"][];
            /** @description What is sewn to what. Their ids are unique. */
            seams?: components["schemas"]["seam"][];
            /** @description Bodies and objects that the cloth hangs on or falls on. Their ids are unique. */
            bodies?: components["schemas"]["body"][];
            /** @description Parts of pieces that are held while the drape begins. */
            attachments?: components["schemas"]["attachment"][];
            /** @description Points that are tied to each other; closed while the seams are sewn. Their ids are unique. */
            buttons?: components["schemas"]["button"][];
            /** @description Bands sewn along edges and lines; they draw in once the garment is sewn. Their ids are unique. */
            elastics?: components["schemas"]["elastic"][];
            /** @description Creases pressed in along lines and seams of pieces. Their ids are unique. */
            folds?: components["schemas"]["fold"][];
            /** @description Closed or nearly closed shapes with air inside. Their ids are unique. */
            cushions?: components["schemas"]["cushion"][];
            settings?: components["schemas"]["settings"];
        };
        /** @description Moves a point of an outline; handles beside it move along, straight curves stay straight. */
        move_point: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "move_point";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Joint of the edge's curves: 0 is its start, their number its end. A corner belongs to both edges. */
            point: number;
            /** @description mm. */
            to: components["schemas"]["pair"];
        };
        /** @description Moves a handle of a curve. */
        move_handle: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "move_handle";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Of the edge, from 0. */
            curve: number;
            /** @description The first or the second. */
            handle: number;
            /** @description mm. */
            to: components["schemas"]["pair"];
        };
        /** @description Parts a curve in two that look the same. */
        insert_point: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "insert_point";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Fraction of the edge's length, in the outline's direction. */
            at: number;
        };
        /** @description Makes one curve of the two beside a point within an edge. */
        delete_point: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "delete_point";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Joint of the edge's curves, neither its start nor its end. */
            point: number;
        };
        /** @description Parts an edge in two. What was sewn stays sewn. */
        split_edge: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "split_edge";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Fraction of the edge's length; a joint of its curves within 0.01 mm is taken. */
            at: number;
            /** @description Of the second part. Without it, the edge's id with a number. */
            id?: components["schemas"]["text"];
        };
        /** @description Makes one edge, under the first one's id, of two that follow each other. What was sewn stays sewn. */
        join_edges: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "join_edges";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Id of the edge that follows in the outline's direction. */
            next: components["schemas"]["text"];
        };
        /** @description Makes a curve straight, or the whole edge one straight line. */
        straighten_edge: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "straighten_edge";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Of the edge, from 0. Default -1: the whole edge. */
            curve?: number;
        };
        /** @description Gives a curve both its handles. */
        bend_edge: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "bend_edge";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Of the edge, from 0. */
            curve: number;
            /** @description mm. */
            handle1: components["schemas"]["pair"];
            /** @description mm. */
            handle2: components["schemas"]["pair"];
        };
        /** @description Scales the edge to a length; the edges beside it follow. */
        set_edge_length: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "set_edge_length";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description mm, along its curves. */
            length_mm: number;
            /**
             * @description What stays in place. Default start.
             * @enum {string}
             */
            keep?: "start" | "middle" | "end";
        };
        /** @description Turns the piece over, about the upright middle line of its box. */
        mirror_piece: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "mirror_piece";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
        };
        /** @description Turns the direction of the warp. */
        rotate_grain: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "rotate_grain";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Degrees, counter-clockwise. */
            angle: number;
        };
        /** @description Draws a line on the piece. */
        add_line: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "add_line";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Unique within the piece. */
            id: components["schemas"]["text"];
            /** @description mm; inside the outline, or on it at the ends. */
            points: components["schemas"]["pair"][];
            /** @description Only drawn: the mesh takes no notice of it. Default false. */
            drawn?: boolean;
        };
        /** @description Takes a line away. */
        remove_line: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "remove_line";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of the line. */
            line: components["schemas"]["text"];
        };
        /** @description Cuts a wedge into an edge and sews its legs together. What was sewn stays sewn on both sides of it. */
        add_dart: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "add_dart";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Where its middle is, as a fraction of the edge's length. */
            at: number;
            /** @description mm, along the edge. */
            width_mm: number;
            /** @description mm, from the edge to the tip. */
            depth_mm: number;
            /** @description Of its seam; the legs are <id>_a and <id>_b. */
            id: components["schemas"]["text"];
        };
        /** @description Cuts a fish-eye dart, a diamond within the cloth, and sews its sides together. */
        add_inner_dart: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "add_inner_dart";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description mm, one tip. */
            from: components["schemas"]["pair"];
            /** @description mm, the other tip. */
            to: components["schemas"]["pair"];
            /** @description mm, where it is widest. */
            width_mm: number;
            /** @description Where it is widest, as a fraction of the way from the first tip. Default 0.5. */
            at?: number;
            /** @description Of its seam; its sides are <id>_a and <id>_b. */
            id: components["schemas"]["text"];
        };
        /** @description Gives an edge another name; seams and all else that names it follow. */
        rename_edge: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "rename_edge";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges or of its holes' edges. */
            edge: components["schemas"]["text"];
            /** @description Its new id, that no edge or line of the piece has. */
            to: components["schemas"]["text"];
        };
        /** @description Takes a dart away: by a straight line over its mouth, or with its hole where it lies within the cloth. */
        remove_dart: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "remove_dart";
            /** @description Id of the seam that closes it. */
            seam: components["schemas"]["text"];
        };
        /** @description Cuts a hole. */
        add_hole: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "add_hole";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Its edges in order, either way round. */
            edges: components["schemas"]["edge"][];
        };
        /** @description Fills a hole; seams of its edges go. */
        remove_hole: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "remove_hole";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges. */
            edge: components["schemas"]["text"];
        };
        /** @description Moves a piece in its drawing. In space it stays where it stands. */
        move_piece: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "move_piece";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description mm. */
            by: components["schemas"]["pair"];
        };
        /** @description Gives a piece another id, wherever it is named. */
        rename_piece: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "rename_piece";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description The new id. */
            to: components["schemas"]["text"];
        };
        /** @description Adds a copy at the end of the list, without seams. */
        duplicate_piece: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "duplicate_piece";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Of the copy. */
            id: components["schemas"]["text"];
            /** @description mm that it lies and stands away from its original. Default [0, 0]. */
            by?: components["schemas"]["pair"];
            /** @description Turned over first. Default false. */
            mirrored?: boolean;
        };
        /** @description Removes a piece, its part of all seams, and what is on it. */
        delete_piece: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "delete_piece";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
        };
        /** @description Sews two series of edges together. */
        add_seam: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "add_seam";
            /** @description Unique among the seams. */
            id: components["schemas"]["text"];
            /** @description One side. */
            a: components["schemas"]["seam_edge"][];
            /** @description The other side. */
            b: components["schemas"]["seam_edge"][];
            /** @description The start of a meets the start of b. Default false: its end. */
            same_direction?: boolean;
        };
        /** @description Takes a seam away. */
        remove_seam: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "remove_seam";
            /** @description Its id. */
            seam: components["schemas"]["text"];
        };
        /** @description Turns the direction of a seam over. */
        reverse_seam: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "reverse_seam";
            /** @description Its id. */
            seam: components["schemas"]["text"];
        };
        /** @description Cuts a piece of another fabric. */
        set_fabric: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "set_fabric";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of a fabric of the document, or the name of one of the library. */
            fabric: components["schemas"]["text"];
        };
        /** @description Prints a picture on a piece, or takes it away. */
        set_texture: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "set_texture";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Without it, the piece has none. */
            texture?: components["schemas"]["texture"];
        };
        /** @description Says what a piece has otherwise than its fabric, or that it has nothing. */
        set_physical: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "set_physical";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description All of it; what is not given is as the fabric has it. */
            physical?: components["schemas"]["physical"];
        };
        /** @description Says by which method the garment is draped. */
        set_solver: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "set_solver";
            /**
             * @description As settings.solver of the document.
             * @enum {string}
             */
            solver: "toile" | "paper";
        };
        /** @description Says when a drape that has not settled ends. */
        set_max_time: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "set_max_time";
            /** @description s of simulated time, as settings.max_time_s of the document. */
            max_time_s: number;
        };
        /** @description Puts back parts of the document's lists: what an undo does. */
        restore: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "restore";
            /** @description Of this list. */
            pieces?: {
                /** @description First element, from 0. */
                at: number;
                /** @description How many go from there on. */
                remove: number;
                /** @description What comes there instead. */
                insert?: components["schemas"]["piece"][];
            };
            /** @description Of this list. */
            seams?: {
                /** @description First element, from 0. */
                at: number;
                /** @description How many go from there on. */
                remove: number;
                /** @description What comes there instead. */
                insert?: components["schemas"]["seam"][];
            };
            /** @description Of this list. */
            attachments?: {
                /** @description First element, from 0. */
                at: number;
                /** @description How many go from there on. */
                remove: number;
                /** @description What comes there instead. */
                insert?: components["schemas"]["attachment"][];
            };
            /** @description Of this list. */
            buttons?: {
                /** @description First element, from 0. */
                at: number;
                /** @description How many go from there on. */
                remove: number;
                /** @description What comes there instead. */
                insert?: components["schemas"]["button"][];
            };
            /** @description Of this list. */
            elastics?: {
                /** @description First element, from 0. */
                at: number;
                /** @description How many go from there on. */
                remove: number;
                /** @description What comes there instead. */
                insert?: components["schemas"]["elastic"][];
            };
            /** @description Of this list. */
            folds?: {
                /** @description First element, from 0. */
                at: number;
                /** @description How many go from there on. */
                remove: number;
                /** @description What comes there instead. */
                insert?: components["schemas"]["fold"][];
            };
            /** @description Of this list. */
            cushions?: {
                /** @description First element, from 0. */
                at: number;
                /** @description How many go from there on. */
                remove: number;
                /** @description What comes there instead. */
                insert?: components["schemas"]["cushion"][];
            };
            /** @description Of this list. */
            bodies?: {
                /** @description First element, from 0. */
                at: number;
                /** @description How many go from there on. */
                remove: number;
                /** @description What comes there instead. */
                insert?: components["schemas"]["body"][];
            };
        };
        /** @description Marks a place on an edge, with a cut into the cloth; the edge gets a point there. */
        add_notch: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "add_notch";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Id of one of its edges. */
            edge: components["schemas"]["text"];
            /** @description Fraction of the edge's length, in the outline's direction. */
            at: number;
            /** @description Depth of the cut. Default 0. */
            depth_mm?: number;
        };
        /** @description Moves a notch to a place on any edge of its piece. */
        move_notch: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "move_notch";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Which one, from 0, in the piece's order. */
            notch: number;
            /** @description Id of the edge to which it comes. */
            edge: components["schemas"]["text"];
            /** @description Fraction of the edge's length, in the outline's direction. */
            at: number;
            /** @description Its depth from here on; without it, as it was. */
            depth_mm?: number;
        };
        /** @description Takes a notch away, and its point where the edge looks the same without it. */
        remove_notch: {
            /**
             * @description Which edit this is.
             * @constant
             */
            edit: "remove_notch";
            /** @description Id of a piece. */
            piece: components["schemas"]["text"];
            /** @description Which one, from 0, in the piece's order. */
            notch: number;
        };
        /**
         * Toile edits
         * @description Edits of a project, one after the other: in requests, in the undo history and in a replay.
         */
        "edit.schema": (components["schemas"]["move_point"] | components["schemas"]["move_handle"] | components["schemas"]["insert_point"] | components["schemas"]["delete_point"] | components["schemas"]["split_edge"] | components["schemas"]["join_edges"] | components["schemas"]["straighten_edge"] | components["schemas"]["bend_edge"] | components["schemas"]["set_edge_length"] | components["schemas"]["mirror_piece"] | components["schemas"]["rotate_grain"] | components["schemas"]["add_line"] | components["schemas"]["remove_line"] | components["schemas"]["add_dart"] | components["schemas"]["add_inner_dart"] | components["schemas"]["rename_edge"] | components["schemas"]["remove_dart"] | components["schemas"]["add_hole"] | components["schemas"]["remove_hole"] | components["schemas"]["move_piece"] | components["schemas"]["rename_piece"] | components["schemas"]["duplicate_piece"] | components["schemas"]["delete_piece"] | components["schemas"]["add_seam"] | components["schemas"]["remove_seam"] | components["schemas"]["reverse_seam"] | components["schemas"]["set_fabric"] | components["schemas"]["set_texture"] | components["schemas"]["set_physical"] | components["schemas"]["set_solver"] | components["schemas"]["set_max_time"] | components["schemas"]["restore"] | components["schemas"]["add_notch"] | components["schemas"]["move_notch"] | components["schemas"]["remove_notch"])[];
        /** @description A thing of the garment or the scene that a finding is about. */
        concern: {
            /**
             * @description "edge": of the piece before it.
             * @enum {string}
             */
            thing: "piece" | "edge" | "seam" | "body";
            /** @description Its id in the document. */
            id: string;
        };
        finding: {
            /** @description Stable, for programs, e.g. "start.crosses_body". */
            code: string;
            /**
             * @description "note", "warning" or "error".
             * @enum {string}
             */
            severity: "note" | "warning" | "error";
            /** @description What it is, in words, and the way out. */
            message: string;
            /** @description The piece, edge or seam, in words. */
            where: string;
            /** @description The same for programs, what has to be seen to first; bodies last. */
            about: components["schemas"]["concern"][];
            /** @description m; x, y, z of the spot, at the start. */
            place: [
                number,
                number,
                number
            ];
            /** @description Whether the start was changed so that it is gone. */
            repaired: boolean;
        };
        figures: {
            /** @description Mean. */
            mean: number;
            /** @description 99th percentile. */
            p99: number;
            /** @description Maximum. */
            max: number;
        };
        /** @description Magnitudes; stretch and squeeze apart in tension and compression, where what is not stretched (squeezed) counts as 0. A fabric's strain limits speak of tension. */
        stretch_figures: {
            /** @description Mean. */
            mean: number;
            /** @description 99th percentile. */
            p99: number;
            /** @description Maximum. */
            max: number;
            /** @description Of stretch alone. */
            tension: components["schemas"]["figures"];
            /** @description Of squeeze alone. */
            compression: components["schemas"]["figures"];
        };
        /**
         * Toile report
         * @description The figures of one drape, as `toile drape` leaves them in report.json.
         */
        "report.schema": {
            /** @description The project's name. */
            name: string;
            /** @description Whether the cloth came to rest. */
            settled: boolean;
            /** @description Why the drape ended: "settled", "time", "cancelled" or what else stopped it. */
            stop_reason: string;
            /** @description s of processor time, all threads together. */
            cpu_s: number;
            /** @description s by the clock. */
            wall_s: number;
            /** @description How often the drape went on from a checkpoint after a stop or a crash; the bytes are the same. */
            resumed: number;
            /** @description Substeps of the solver. */
            steps: number;
            /** @description s of simulated time. */
            simulated_s: number;
            /** @description Vertices of the flat pieces. */
            particles: number;
            /** @description Vertices of the garment: what is sewn together counts once. */
            sewn_particles: number;
            /** @description Triangles of the cloth. */
            triangles: number;
            /** @description Triangles of all bodies. */
            body_triangles: number;
            /** @description Crossings, counted exactly: an edge of one triangle through the inside of another. At the end, and in the worst of the frames that were checked. */
            intersections: {
                /** @description Of cloth with bodies, at the end. */
                cloth_body: number;
                /** @description Of cloth with cloth, at the end. */
                cloth_cloth: number;
                /** @description The frame with the most crossings. */
                worst_frame: {
                    /** @description Its substep. */
                    step: number;
                    /** @description Of cloth with bodies. */
                    cloth_body: number;
                    /** @description Of cloth with cloth. */
                    cloth_cloth: number;
                };
                /** @description How many frames were checked. */
                frames_checked: number;
            };
            /** @description mm; the widest distance between two sewn vertices at the end. */
            seam_gap_max_mm: number;
            /** @description The seams that did not close. */
            open_seams: {
                /** @description Its name; empty where it has none. */
                id: string;
                /** @description mm; how far it is open, at most. */
                gap_mm: number;
            }[];
            /**
             * @description Whether the body wears the garment: every ring around the limb that it is for, and nothing fallen. partly: but for a seam that is open. Absent where nobody stands there, and where cloth without seams stays on the body.
             * @enum {string}
             */
            worn?: "yes" | "partly" | "no";
            /** @description What the document's attachments did, in their order. */
            attachments: {
                /** @description Its name; empty where it has none. */
                id: string;
                /** @description Whether it has let go. */
                released: boolean;
                /** @description mm; how far what it holds was from where it should be, at most: when it was released, or else at the end. */
                off_mm: number;
                /** @description s of simulated time; absent while it holds. */
                released_s?: number;
            }[];
            /** @description Magnitudes of strain over the triangles at the end: stretch as a ratio, shear in radians. */
            strain: {
                /** @description Along the warp. */
                warp: components["schemas"]["stretch_figures"];
                /** @description Along the weft. */
                weft: components["schemas"]["stretch_figures"];
                /** @description Between warp and weft. */
                shear: components["schemas"]["figures"];
            };
            /** @description Girths of body and garment and the ease between, as far as somebody stands there and the garment goes around. */
            fit?: {
                /** @description "bust", "waist", "hip", "thigh_left", "upper_arm_right", … */
                at: string;
                /**
                 * @description stretched: narrower than the body, and the cloth gives without pressing; too_tight: narrower than it gives.
                 * @enum {string}
                 */
                fit: "fits" | "stretched" | "too_tight";
                /** @description The line in words: "waist 2.1 cm too tight". */
                text: string;
                /** @description mm; of the body. */
                body_mm: number;
                /** @description mm; of the flat pieces. */
                garment_mm: number;
                /** @description mm; the garment's girth less the body's. */
                ease_mm: number;
                /** @description mm; of the cloth as it hangs, stretch included. */
                worn_mm: number;
                /** @description mm that it should be wider; 0 where it is not too tight. */
                tight_by_mm: number;
                /** @description mm, how far above (along limbs towards the trunk) where that girth is usually taken: the nearest place that the garment goes around. */
                shifted_mm: number;
                /** @description Those that the way goes through. */
                pieces: string[];
                /** @description m; x, y, z of the body's middle there. */
                place: [
                    number,
                    number,
                    number
                ];
            }[];
            /** @description m/s; root mean square over the particles at the end. */
            rms_speed: number;
            /** @description m/s; of the fastest particle at the end. */
            max_speed: number;
            /** @description m; height of the cloth's lowest point. */
            lowest_m: number;
            /** @description m; height of the cloth's highest point. */
            highest_m: number;
            /** @description What the look at the start found, worst first. */
            findings: components["schemas"]["finding"][];
            /** @description 128-bit XXH3 of the final positions, 32 hex digits: the same input gives the same hash. */
            hash: string;
        };
        JobMessage: components["schemas"]["JobFields"] & {
            /** @constant */
            type: "job";
            progress: components["schemas"]["JobProgress"];
        };
        ProgressMessage: components["schemas"]["ProgressFields"] & {
            /** @constant */
            type: "progress";
        };
        EndedMessage: components["schemas"]["ProgressFields"] & {
            /** @constant */
            type: "ended";
            job: components["schemas"]["EndedJob"];
        };
        ErrorMessage: {
            /** @constant */
            type: "error";
            code: string;
            detail: string;
            where: string;
        };
        Control: {
            /** @enum {unknown} */
            type: "pause" | "resume" | "step" | "cancel" | "let_go";
        };
        Pull: {
            /** @constant */
            type: "pull";
            /** @description of the topology */
            epoch: number;
            triangle: number;
            shares: components["schemas"]["Shares"];
            /** @description m */
            to: [
                number,
                number,
                number
            ];
        };
        Pin: {
            /** @constant */
            type: "pin";
            /** @description of the topology */
            epoch: number;
            triangle: number;
            shares: components["schemas"]["Shares"];
        };
        Unpin: {
            /** @constant */
            type: "unpin";
            /** @description its number, as progress has it */
            pin: number;
        };
        /** @description Of the triangle's corners, in their order; their sum is 1 */
        Shares: [
            number,
            number,
            number
        ];
        EndedJob: components["schemas"]["JobFields"];
        JobProgress: components["schemas"]["ProgressFields"];
    };
    responses: {
        /** @description What went wrong, and where */
        Problem: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/problem+json": components["schemas"]["Problem"];
            };
        };
        /** @description It is well */
        Health: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/json": {
                    /** @enum {unknown} */
                    status: "ok" | "ready";
                };
            };
        };
        /** @description The asset, new or as it was already there */
        AssetCreated: {
            headers: {
                Location: components["headers"]["Location"];
                [name: string]: unknown;
            };
            content: {
                "application/json": components["schemas"]["Asset"];
            };
        };
        /** @description The assets */
        AssetList: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/json": {
                    assets: components["schemas"]["Asset"][];
                };
            };
        };
        /** @description The project */
        Project: {
            headers: {
                ETag: components["headers"]["ETag"];
                [name: string]: unknown;
            };
            content: {
                "application/json": components["schemas"]["Project"];
            };
        };
        /** @description The project */
        ProjectMade: {
            headers: {
                Location: components["headers"]["Location"];
                ETag: components["headers"]["ETag"];
                [name: string]: unknown;
            };
            content: {
                "application/json": components["schemas"]["Project"];
            };
        };
        /** @description The job */
        Job: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/json": components["schemas"]["Job"];
            };
        };
        /** @description The links */
        Links: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/json": {
                    links: components["schemas"]["Link"][];
                };
            };
        };
        /** @description How the movie stands; 200 when it is made, 202 while it is not */
        Movie: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/json": {
                    movie: components["schemas"]["Movie"];
                };
            };
        };
        /** @description How the still stands; 200 when it is taken, 202 while it is not */
        Still: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/json": {
                    still: components["schemas"]["Still"];
                };
            };
        };
        /** @description The sweep with its cells */
        Sweep: {
            headers: {
                [name: string]: unknown;
            };
            content: {
                "application/json": components["schemas"]["Sweep"];
            };
        };
        /** @description The sweep with its cells */
        SweepMade: {
            headers: {
                Location: components["headers"]["Location"];
                [name: string]: unknown;
            };
            content: {
                "application/json": components["schemas"]["Sweep"];
            };
        };
        /** @description The job */
        JobMade: {
            headers: {
                Location: components["headers"]["Location"];
                [name: string]: unknown;
            };
            content: {
                "application/json": components["schemas"]["Job"];
            };
        };
    };
    parameters: {
        /** @example l_1qedqq1nd5hfbjxpm78j */
        LinkId: string;
        /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
        AssetId: string;
        /** @example p_1qedqq1nd5hfbjxpm78j */
        ProjectId: string;
        /** @example v_1qedqq1nd5hfbjxpm78j */
        VersionId: string;
        /** @example s_1qedqq1nd5hfbjxpm78j */
        SweepId: string;
        /** @example w_1qedqq1nd5hfbjxpm78j */
        WebhookId: string;
        /**
         * @description ETags of what the client has
         * @example "ba5eba11ba5eba11ba5eba11ba5eba11"
         */
        IfNoneMatch: string;
        /** @example j_1qedqq1nd5hfbjxpm78j */
        JobId: string;
        /**
         * @description File name without folders; that of a body ends as its format does
         * @example skirt.dxf
         */
        FileName: string;
        /**
         * @description 1 to 200 printable characters, for a request that may be sent again because its answer got lost. What the
         *     first one made is answered with 201, and with 200 from then on.
         * @example 5f0c1b9e-7a52-4b0e-9a53-2a0f1f1a7a11
         */
        IdempotencyKey: string;
        /**
         * @description The ETag of the revision that this changes, or * for whichever there is
         * @example "3"
         */
        IfMatch: string;
        /** @description The "next" of the page before */
        Cursor: string;
        Limit: number;
    };
    requestBodies: {
        File: {
            content: {
                "application/octet-stream": unknown;
                "image/vnd.dxf": unknown;
                "model/obj": unknown;
            };
        };
        Project: {
            content: {
                /**
                 * @example {
                 *       "document": {
                 *         "toile": 1,
                 *         "name": "Napkin",
                 *         "pieces": [
                 *           {
                 *             "id": "napkin",
                 *             "from": {
                 *               "dxf": "napkin.dxf",
                 *               "piece": "napkin"
                 *             },
                 *             "fabric": "cotton",
                 *             "placement": {
                 *               "rigid": {
                 *                 "translation": [
                 *                   -0.15,
                 *                   0.52,
                 *                   0.15
                 *                 ],
                 *                 "rotation": [
                 *                   -90,
                 *                   0,
                 *                   0
                 *                 ]
                 *               }
                 *             }
                 *           }
                 *         ],
                 *         "fabrics": [
                 *           {
                 *             "id": "cotton",
                 *             "areal_mass_g_m2": 110,
                 *             "stretch_warp_n_m": 600,
                 *             "stretch_weft_n_m": 600,
                 *             "stretch_shear_n_m": 30,
                 *             "bend_warp_un_m": 6,
                 *             "bend_weft_un_m": 4,
                 *             "bend_bias_un_m": 5,
                 *             "thickness_mm": 0.3
                 *           }
                 *         ],
                 *         "seams": [],
                 *         "bodies": [
                 *           {
                 *             "id": "post",
                 *             "file": "post.obj",
                 *             "unit": "m"
                 *           }
                 *         ]
                 *       },
                 *       "files": {
                 *         "napkin.dxf": "a_54ce42ce6ee49336caaa45f5216ac786",
                 *         "post.obj": "a_185b51bfe69fa48fcfaabd3c3951412c"
                 *       }
                 *     }
                 */
                "application/json": {
                    /** @description Stands for the document's own name */
                    name?: string;
                    document: components["schemas"]["project.schema"];
                    files?: components["schemas"]["Files"];
                };
            };
        };
    };
    headers: {
        /** @description Address of what was made */
        Location: string;
        /**
         * @description The project's revision in double quotes
         * @example "3"
         */
        ETag: string;
        /**
         * @description What tells the file's bytes from all others
         * @example "ba5eba11ba5eba11ba5eba11ba5eba11"
         */
        FileETag: string;
    };
    pathItems: never;
}
export type $defs = Record<string, never>;
export interface operations {
    showSession: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The one user of a server without accounts, or somebody who is known */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Session"];
                };
            };
            401: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    logIn: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "name": "anna",
                 *       "password": "a long one to remember"
                 *     }
                 */
                "application/json": {
                    name: string;
                    password: string;
                } | {
                    token: string;
                };
            };
        };
        responses: {
            /** @description Somebody is known */
            204: {
                headers: {
                    "Set-Cookie"?: string;
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem"];
            401: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    logOut: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It has ended, for whoever has its cookie */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            401: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listKeys: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The keys */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        keys: components["schemas"]["Key"][];
                    };
                };
            };
            401: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    revokeKey: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is gone */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listAssets: {
        parameters: {
            query?: {
                kind?: components["schemas"]["AssetKind"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["AssetList"];
            400: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    uploadAsset: {
        parameters: {
            query: {
                kind: components["schemas"]["AssetKind"];
                /**
                 * @description File name without folders; that of a body ends as its format does
                 * @example skirt.dxf
                 */
                name: components["parameters"]["FileName"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: components["requestBodies"]["File"];
        responses: {
            201: components["responses"]["AssetCreated"];
            400: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listBodies: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["AssetList"];
            421: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    uploadBody: {
        parameters: {
            query: {
                /**
                 * @description File name without folders; that of a body ends as its format does
                 * @example skirt.dxf
                 */
                name: components["parameters"]["FileName"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: components["requestBodies"]["File"];
        responses: {
            201: components["responses"]["AssetCreated"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listFabrics: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The fabrics */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        fabrics: components["schemas"]["fabric.schema"][];
                    };
                };
            };
            421: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showFabric: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example single-jersey */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The fabric */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["fabric.schema"];
                };
            };
            404: components["responses"]["Problem"];
            421: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listBodyPresets: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The presets */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["BodyPresets"];
                };
            };
            421: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    makeBody: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "mannequin": {
                 *         "preset": "eu38",
                 *         "waist_cm": 70,
                 *         "triangles": 3000
                 *       },
                 *       "name": "anna.obj"
                 *     }
                 */
                "application/json": {
                    mannequin: components["schemas"]["mannequin"];
                    /** @description Of the file; with or without ".obj" */
                    name?: string;
                };
            };
        };
        responses: {
            /** @description The file and the figure */
            201: {
                headers: {
                    Location: components["headers"]["Location"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Figure"] & {
                        asset: components["schemas"]["Asset"];
                    };
                };
            };
            400: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showBodyFigure: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The figure */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Figure"] & {
                        stance: components["schemas"]["Stance"];
                    };
                };
            };
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showAsset: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The asset */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Asset"];
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    removeAsset: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is gone */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    assetContent: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Its bytes, as they were uploaded */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": unknown;
                    "image/vnd.dxf": unknown;
                    "image/png": unknown;
                    "image/jpeg": unknown;
                    "model/obj": unknown;
                    "model/gltf-binary": unknown;
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    importPattern: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "asset": "a_54ce42ce6ee49336caaa45f5216ac786",
                 *       "unit": "cm",
                 *       "layers": {
                 *         "3": "sew"
                 *       }
                 *     }
                 */
                "application/json": {
                    /** @description id of an uploaded DXF or specification */
                    asset: string;
                    /**
                     * @description Overrules what the file says
                     * @enum {unknown}
                     */
                    unit?: "mm" | "cm" | "inch";
                    /** @description To take of a graded DXF, instead of its sample size */
                    size?: string;
                    layers?: components["schemas"]["LayerMap"];
                };
            };
        };
        responses: {
            /** @description The report */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Import"];
                };
            };
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listLayers: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example a_54ce42ce6ee49336caaa45f5216ac786 */
                id: components["parameters"]["AssetId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The layers, those with numbers first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        asset: string;
                        file: string;
                        layers: components["schemas"]["Layer"][];
                    };
                };
            };
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listProjects: {
        parameters: {
            query?: {
                /** @description The "next" of the page before */
                cursor?: components["parameters"]["Cursor"];
                limit?: components["parameters"]["Limit"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A page of them */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        projects: components["schemas"]["ProjectSummary"][];
                        next: components["schemas"]["NextCursor"];
                    };
                };
            };
            400: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    createProject: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description 1 to 200 printable characters, for a request that may be sent again because its answer got lost. What the
                 *     first one made is answered with 201, and with 200 from then on.
                 * @example 5f0c1b9e-7a52-4b0e-9a53-2a0f1f1a7a11
                 */
                "Idempotency-Key"?: components["parameters"]["IdempotencyKey"];
            };
            path?: never;
            cookie?: never;
        };
        requestBody: components["requestBodies"]["Project"];
        responses: {
            200: components["responses"]["ProjectMade"];
            201: components["responses"]["ProjectMade"];
            400: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showProject: {
        parameters: {
            query?: never;
            header?: {
                /** @example "3" */
                "If-None-Match"?: string;
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Project"];
            /** @description It still has the revision of If-None-Match */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    replaceProject: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody: components["requestBodies"]["Project"];
        responses: {
            200: components["responses"]["Project"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    removeProject: {
        parameters: {
            query?: {
                /** @description true removes its jobs with their results and the files that nothing else uses; 409 while a job has not ended */
                data?: boolean;
            };
            header?: {
                /**
                 * @description The ETag of the revision to remove; without it, or with *, whichever there is
                 * @example "3"
                 */
                "If-Match"?: string;
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is gone */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listEdits: {
        parameters: {
            query?: {
                /** @description The "next" of the page before */
                cursor?: components["parameters"]["Cursor"];
                limit?: components["parameters"]["Limit"];
            };
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A page of the history */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        edits: components["schemas"]["EditStep"][];
                        next: components["schemas"]["NextCursor"];
                    };
                };
            };
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    editProject: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "edits": [
                 *         {
                 *           "edit": "move_point",
                 *           "piece": "front",
                 *           "edge": "hem",
                 *           "point": 1,
                 *           "to": [
                 *             120,
                 *             -4.5
                 *           ]
                 *         },
                 *         {
                 *           "edit": "split_edge",
                 *           "piece": "front",
                 *           "edge": "waist",
                 *           "at": 0.5,
                 *           "id": "waist_right"
                 *         },
                 *         {
                 *           "edit": "set_texture",
                 *           "piece": "front",
                 *           "texture": {
                 *             "image": "tartan.png",
                 *             "scale_mm": 120,
                 *             "angle": 45
                 *           }
                 *         }
                 *       ],
                 *       "files": {
                 *         "tartan.png": "a_185b51bfe69fa48fcfaabd3c3951412c"
                 *       }
                 *     }
                 */
                "application/json": {
                    edits: components["schemas"]["edit.schema"];
                    /**
                     * @description Files that come to the project's own, such as the picture of set_texture; they stay when the edits are undone.
                     *     A name that stands for another file already is refused (documents.file_taken).
                     */
                    files?: components["schemas"]["Files"];
                };
            };
        };
        responses: {
            200: components["responses"]["Project"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    undoEdits: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Project"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    redoEdits: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Project"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listVersions: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description All versions, 200 at most */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        versions: components["schemas"]["Version"][];
                    };
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    nameVersion: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "name": "with a slit"
                 *     }
                 */
                "application/json": {
                    /** @description 80 bytes at most */
                    name: string;
                };
            };
        };
        responses: {
            /** @description The version */
            201: {
                headers: {
                    Location: components["headers"]["Location"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Version"];
                };
            };
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    restoreVersion: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @example v_1qedqq1nd5hfbjxpm78j */
                version: components["parameters"]["VersionId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Project"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    removeVersion: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @example v_1qedqq1nd5hfbjxpm78j */
                version: components["parameters"]["VersionId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is gone */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    proposeSeams: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The proposals */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        proposals: components["schemas"]["SeamProposal"][];
                    };
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showProjectBodies: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The bodies, in the document's order */
            200: {
                headers: {
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        bodies: components["schemas"]["ProjectBody"][];
                    };
                };
            };
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    dressProject: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @description Id of a body in the document; one that is not there comes to the others */
                body: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "mannequin": {
                 *         "preset": "eu38",
                 *         "hip_cm": 100
                 *       },
                 *       "skin_offset_mm": 3
                 *     }
                 */
                "application/json": {
                    mannequin?: components["schemas"]["mannequin"];
                    /** @description Id of an uploaded body */
                    asset?: string;
                    /**
                     * @description Of the file
                     * @enum {string}
                     */
                    unit?: "m" | "cm" | "mm";
                    /**
                     * @description Which axis of the file points upwards
                     * @enum {string}
                     */
                    up?: "y" | "z";
                    /** @description Degrees about the upright axis */
                    turn?: number;
                    friction?: number;
                    skin_offset_mm?: number;
                } & (unknown | unknown);
            };
        };
        responses: {
            200: components["responses"]["Project"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    undressProject: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @description Id of a body in the document; one that is not there comes to the others */
                body: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Project"];
            404: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    moveLandmark: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @description Id of a body in the document */
                body: string;
                /** @description Name of a landmark that the body has or gets */
                landmark: string;
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "place": [
                 *         0.1,
                 *         1.2,
                 *         0.12
                 *       ]
                 *     }
                 */
                "application/json": {
                    place: components["schemas"]["Place"];
                };
            };
        };
        responses: {
            200: components["responses"]["Project"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    forgetLandmark: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
                /** @description Id of a body in the document */
                body: string;
                /** @description Name of a landmark that the body has or gets */
                landmark: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Project"];
            404: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    projectBody: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /**
             * @description Little endian: uint32 vertices, uint32 triangles, float32 x, y, z of each vertex (m, y up), three uint32 a
             *     triangle
             */
            200: {
                headers: {
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": unknown;
                };
            };
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    arrangeProject: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The project, what was decided for each piece, and what the look at the start found */
            200: {
                headers: {
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["ProjectFields"] & {
                        document: components["schemas"]["project.schema"];
                        arrangement: components["schemas"]["Arrangement"];
                    };
                };
            };
            404: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    placePiece: {
        parameters: {
            query?: never;
            header: {
                /**
                 * @description The ETag of the revision that this changes, or * for whichever there is
                 * @example "3"
                 */
                "If-Match": components["parameters"]["IfMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "piece": "front",
                 *       "part": "torso",
                 *       "side": "front",
                 *       "at_mm": [
                 *         0,
                 *         40
                 *       ],
                 *       "away_mm": 60
                 *     }
                 */
                "application/json": {
                    piece: string;
                    part?: components["schemas"]["body_part"];
                    side?: components["schemas"]["box_side"];
                    /** @description From the side's middle, to the right as one looks at it and up */
                    at_mm?: [
                        number,
                        number
                    ];
                    /**
                     * @description Before the side
                     * @default 50
                     */
                    away_mm?: number;
                    /**
                     * @description Degrees, counter-clockwise
                     * @default 0
                     */
                    turn?: number;
                    /**
                     * @description Rolled around the part
                     * @default false
                     */
                    wrapped?: boolean;
                    /**
                     * @description Turned over, the right side to the body
                     * @default false
                     */
                    flipped?: boolean;
                    /**
                     * @description The piece's mirror image in the garment, if there is one, goes to the other side
                     * @default false
                     */
                    with_partner?: boolean;
                };
            };
        };
        responses: {
            200: components["responses"]["Project"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            412: components["responses"]["Problem"];
            413: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            428: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    checkProject: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description What it finds, errors first, and where the pieces stand after what could be repaired */
            200: {
                headers: {
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Check"];
                };
            };
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    projectStart: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /**
             * @description Little endian: uint32 bytes of the topology, the topology message of frames.md (epoch 1), float32 x, y, z of
             *     each vertex (m, y up)
             */
            200: {
                headers: {
                    ETag: components["headers"]["ETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": unknown;
                };
            };
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showPieces: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Millimetres, y up, curves flattened to 0.2 mm */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["Pieces"];
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    patternDxf: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description ETags of what the client has
                 * @example "ba5eba11ba5eba11ba5eba11ba5eba11"
                 */
                "If-None-Match"?: components["parameters"]["IfNoneMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Millimetres; boundary, notches, grain and inner lines in layers, for cutting tables and other programs */
            200: {
                headers: {
                    ETag: components["headers"]["FileETag"];
                    [name: string]: unknown;
                };
                content: {
                    "image/vnd.dxf": unknown;
                };
            };
            /** @description The file would have the bytes of If-None-Match */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    patternSvg: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description ETags of what the client has
                 * @example "ba5eba11ba5eba11ba5eba11ba5eba11"
                 */
                "If-None-Match"?: components["parameters"]["IfNoneMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Millimetres; for plotters and drawing programs */
            200: {
                headers: {
                    ETag: components["headers"]["FileETag"];
                    [name: string]: unknown;
                };
                content: {
                    "image/svg+xml": unknown;
                };
            };
            /** @description The file would have the bytes of If-None-Match */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    patternPdf: {
        parameters: {
            query?: {
                /** @description Of the pages */
                paper?: components["schemas"]["Paper"];
            };
            header?: {
                /**
                 * @description ETags of what the client has
                 * @example "ba5eba11ba5eba11ba5eba11ba5eba11"
                 */
                "If-None-Match"?: components["parameters"]["IfNoneMatch"];
            };
            path: {
                /** @example p_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["ProjectId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A page that shows how the others lie, then those; on one of them a square of 50 mm to measure. Lines are where pieces are sewn */
            200: {
                headers: {
                    ETag: components["headers"]["FileETag"];
                    [name: string]: unknown;
                };
                content: {
                    "application/pdf": unknown;
                };
            };
            /** @description The file would have the bytes of If-None-Match */
            304: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listJobs: {
        parameters: {
            query?: {
                /**
                 * @description One of these, with commas between them
                 * @example queued,running
                 */
                state?: string;
                /**
                 * @description Of this project
                 * @example p_1qedqq1nd5hfbjxpm78j
                 */
                project?: string;
                /**
                 * @description With this tag
                 * @example spring
                 */
                tag?: string;
                /**
                 * @description Of this sweep; none: of no sweep
                 * @example s_1qedqq1nd5hfbjxpm78j
                 */
                sweep?: string;
                /** @description Made then or later, Unix milliseconds */
                since?: number;
                /** @description Made before, Unix milliseconds */
                until?: number;
                /** @description The "next" of the page before */
                cursor?: components["parameters"]["Cursor"];
                limit?: components["parameters"]["Limit"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A page of them */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        jobs: components["schemas"]["JobSummary"][];
                        next: components["schemas"]["NextCursor"];
                    };
                };
            };
            400: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    submitJob: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description 1 to 200 printable characters, for a request that may be sent again because its answer got lost. What the
                 *     first one made is answered with 201, and with 200 from then on.
                 * @example 5f0c1b9e-7a52-4b0e-9a53-2a0f1f1a7a11
                 */
                "Idempotency-Key"?: components["parameters"]["IdempotencyKey"];
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "project_id": "p_1qedqq1nd5hfbjxpm78j",
                 *       "priority": "interactive"
                 *     }
                 */
                "application/json": {
                    project_id: string;
                    priority?: components["schemas"]["JobPriority"];
                    tags?: components["schemas"]["Tags"];
                    /**
                     * @description id of a job that has ended: the drape goes on from how the garment hung then, though the pattern, the fabric or
                     *     the body has been edited since, and takes a fraction of the time. Where that cannot be it begins from the
                     *     pieces, and a finding of the report says why (start.from_the_pieces). Its results are those of this way.
                     */
                    from?: string;
                    /**
                     * @description false: no pictures are drawn of the end, which takes longer than a small drape
                     * @default true
                     */
                    pictures?: boolean;
                    /**
                     * @description drapes although the results of an equal drape would do
                     * @default false
                     */
                    anew?: boolean;
                };
            };
        };
        responses: {
            200: components["responses"]["JobMade"];
            201: components["responses"]["JobMade"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Job"];
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    removeJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is gone */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    tagJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "tags": [
                 *         "spring",
                 *         "atelier"
                 *       ]
                 *     }
                 */
                "application/json": {
                    tags: components["schemas"]["Tags"];
                };
            };
        };
        responses: {
            /** @description Those that it has now */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        tags: components["schemas"]["Tags"];
                    };
                };
            };
            404: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    pauseJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Job"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    resumeJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Job"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    stepJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Job"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    cancelJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Job"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    retryJob: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description 1 to 200 printable characters, for a request that may be sent again because its answer got lost. What the
                 *     first one made is answered with 201, and with 200 from then on.
                 * @example 5f0c1b9e-7a52-4b0e-9a53-2a0f1f1a7a11
                 */
                "Idempotency-Key"?: components["parameters"]["IdempotencyKey"];
            };
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["JobMade"];
            201: components["responses"]["JobMade"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    goOnJob: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description 1 to 200 printable characters, for a request that may be sent again because its answer got lost. What the
                 *     first one made is answered with 201, and with 200 from then on.
                 * @example 5f0c1b9e-7a52-4b0e-9a53-2a0f1f1a7a11
                 */
                "Idempotency-Key"?: components["parameters"]["IdempotencyKey"];
            };
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["JobMade"];
            201: components["responses"]["JobMade"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            503: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listResults: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description None until it has ended */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        results: components["schemas"]["ResultFile"][];
                    };
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    resultContent: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
                /** @example final.glb */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Its bytes */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                    "application/octet-stream": unknown;
                    "image/png": unknown;
                    "model/gltf-binary": unknown;
                    "model/obj": unknown;
                    "video/mp4": unknown;
                    "video/x-msvideo": unknown;
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    smallResult: {
        parameters: {
            query?: {
                /** @description Pixels; the height follows. A picture that is no wider comes as it is */
                width?: number;
            };
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
                /** @example front.png */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A PNG, which may be kept as long as the job is */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "image/png": unknown;
                };
            };
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listMovies: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description All of them */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        movies: components["schemas"]["Movie"][];
                    };
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    makeMovie: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "kind": "turntable",
                 *       "width": 480,
                 *       "height": 600
                 *     }
                 */
                "application/json": {
                    /**
                     * @description drape is the way from the pieces to the end; turntable the end, turned once
                     * @default drape
                     * @enum {string}
                     */
                    kind?: "drape" | "turntable";
                    /**
                     * @description H.264 or Motion JPEG
                     * @default mp4
                     * @enum {string}
                     */
                    format?: "mp4" | "avi";
                    /**
                     * @description pixels
                     * @default 720
                     */
                    width?: number;
                    /**
                     * @description pixels
                     * @default 900
                     */
                    height?: number;
                    /** @default 25 */
                    fps?: number;
                    /** @description How long it lasts; without it a drape as long as it did but 20 s at most, a turn 8 s */
                    seconds?: number;
                };
            };
        };
        responses: {
            200: components["responses"]["Movie"];
            202: components["responses"]["Movie"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    cancelMovie: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
                /** @example turntable-480x600-25.mp4 */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is taken back */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listStills: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description All of them */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        stills: components["schemas"]["Still"][];
                    };
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    takeStill: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "view": "front",
                 *       "map": "ease",
                 *       "width": 800,
                 *       "height": 1000
                 *     }
                 */
                "application/json": {
                    /**
                     * @description from where the whole garment is in the picture; not beside eye
                     * @default three-quarter
                     * @enum {string}
                     */
                    view?: "front" | "back" | "side" | "right" | "three-quarter" | "back-quarter";
                    /** @description where an own camera stands */
                    eye?: components["schemas"]["ScenePoint"];
                    /** @description what it looks at; without it the middle of the cloth */
                    target?: components["schemas"]["ScenePoint"];
                    /**
                     * @description degrees that it sees from top to bottom
                     * @default 21.5
                     */
                    angle?: number;
                    /**
                     * @description what the cloth is coloured by, as maps.json has it
                     * @enum {string}
                     */
                    map?: "warp" | "weft" | "shear" | "ease" | "curvature" | "pressure";
                    /**
                     * @description pixels
                     * @default 1024
                     */
                    width?: number;
                    /**
                     * @description pixels
                     * @default 1280
                     */
                    height?: number;
                    /**
                     * @description no backdrop, and of the ground the shadow only
                     * @default false
                     */
                    transparent?: boolean;
                };
            };
        };
        responses: {
            200: components["responses"]["Still"];
            202: components["responses"]["Still"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    cancelStill: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
                /** @example still-front-ease-800x1000.png */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is taken back */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    reportPage: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A page with nothing outside it, made when it is asked for */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/html": unknown;
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    logOfJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The lines; none when nothing has been done yet */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/x-ndjson": unknown;
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    jobPieces: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The pieces, and the fabrics of the library among theirs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SeenPieces"];
                };
            };
            404: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    jobBody: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /**
             * @description Little endian: uint32 number of vertices, uint32 number of triangles, float32 x, y, z of each vertex
             *     (metres, y up), three uint32 vertex numbers of each triangle.
             */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": unknown;
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listLinksOfJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Links"];
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    shareJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "label": "For the atelier",
                 *       "days": 30,
                 *       "take": [
                 *         "pictures",
                 *         "report"
                 *       ]
                 *     }
                 */
                "application/json": {
                    /** @description What its owner calls it */
                    label?: string;
                    /** @description How long it is good; null for ever */
                    days?: number | null;
                    /** @default [] */
                    take?: components["schemas"]["Taking"][];
                };
            };
        };
        responses: {
            /** @description The link with its secret */
            201: {
                headers: {
                    Location: components["headers"]["Location"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        link: components["schemas"]["Link"];
                        secret: string;
                        /** @description Where the page of this server shows it */
                        page: string;
                    };
                };
            };
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    streamJob: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example j_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["JobId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The connection is a WebSocket now */
            101: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            403: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            426: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listSweeps: {
        parameters: {
            query?: {
                /**
                 * @description Of this project
                 * @example p_1qedqq1nd5hfbjxpm78j
                 */
                project?: string;
                /** @description The "next" of the page before */
                cursor?: components["parameters"]["Cursor"];
                limit?: components["parameters"]["Limit"];
            };
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A page of them */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        sweeps: components["schemas"]["SweepSummary"][];
                        next: components["schemas"]["NextCursor"];
                    };
                };
            };
            400: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    submitSweep: {
        parameters: {
            query?: never;
            header?: {
                /**
                 * @description 1 to 200 printable characters, for a request that may be sent again because its answer got lost. What the
                 *     first one made is answered with 201, and with 200 from then on.
                 * @example 5f0c1b9e-7a52-4b0e-9a53-2a0f1f1a7a11
                 */
                "Idempotency-Key"?: components["parameters"]["IdempotencyKey"];
            };
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "project_id": "p_1qedqq1nd5hfbjxpm78j",
                 *       "bodies": [
                 *         "eu36",
                 *         {
                 *           "mannequin": {
                 *             "preset": "eu40",
                 *             "waist_cm": 80
                 *           }
                 *         }
                 *       ],
                 *       "fabrics": [
                 *         "poplin",
                 *         "denim-10oz"
                 *       ]
                 *     }
                 */
                "application/json": {
                    project_id: string;
                    /** @description The project's where it is not there */
                    name?: string;
                    /** @description Id of the body in the document that those of the sweep replace; the first where it is not there */
                    body?: string;
                    /** @description Its rows; the project's own body alone where they are not there */
                    bodies?: components["schemas"]["SweepBody"][];
                    /** @description Its columns; as the project is cut where they are not there */
                    fabrics?: components["schemas"]["SweepFabric"][];
                    priority?: components["schemas"]["JobPriority"];
                    tags?: components["schemas"]["Tags"];
                    /**
                     * @description false: no pictures are drawn, and the contact sheet shows none
                     * @default true
                     */
                    pictures?: boolean;
                    /**
                     * @description drapes although the results of equal drapes would do
                     * @default false
                     */
                    anew?: boolean;
                };
            };
        };
        responses: {
            200: components["responses"]["Sweep"];
            201: components["responses"]["SweepMade"];
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showSweep: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Sweep"];
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    removeSweep: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is gone */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    cancelSweep: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Sweep"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sweepTable: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A line of names, and one for each cell; a cell without a report has empty fields */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/csv": unknown;
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sweepSheet: {
        parameters: {
            query?: {
                view?: "front" | "side" | "back";
            };
            header?: never;
            path: {
                /** @example s_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["SweepId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The sheet */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "image/png": unknown;
                };
            };
            400: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listenToEvents: {
        parameters: {
            query?: {
                /** @description The same; 0 gives all that are kept. Without either, what happens from now on */
                after?: number;
            };
            header?: {
                /** @description The event that was heard last; goes before `after` */
                "Last-Event-ID"?: number;
            };
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Events as they happen, without end */
            200: {
                headers: {
                    /** @description The event after which it begins */
                    "Last-Event-ID"?: number;
                    [name: string]: unknown;
                };
                content: {
                    "text/event-stream": components["schemas"]["JobEvent"];
                };
            };
            400: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listWebhooks: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description All of them, without their secrets */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        webhooks: components["schemas"]["Webhook"][];
                    };
                };
            };
            401: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    makeWebhook: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                /**
                 * @example {
                 *       "url": "https://example.org/toile",
                 *       "states": [
                 *         "succeeded",
                 *         "failed"
                 *       ]
                 *     }
                 */
                "application/json": {
                    /** @description http or https */
                    url: string;
                    /** @description Those that are told; all where it is not there */
                    states?: [
                        components["schemas"]["FinalState"],
                        ...components["schemas"]["FinalState"][]
                    ];
                    label?: string;
                };
            };
        };
        responses: {
            /** @description The webhook with its secret */
            201: {
                headers: {
                    Location: components["headers"]["Location"];
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        webhook: components["schemas"]["Webhook"];
                        secret: string;
                    };
                };
            };
            400: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            415: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    removeWebhook: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example w_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["WebhookId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is gone */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    pingWebhook: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example w_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["WebhookId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It will be told; the deliveries say how it went */
            202: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listDeliveries: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example w_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["WebhookId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Newest first */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        deliveries: components["schemas"]["Delivery"][];
                    };
                };
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    listLinks: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Links"];
            401: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    revokeLink: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description It is taken back */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            404: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    openLink: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody: {
            content: {
                "application/json": {
                    secret: string;
                };
            };
        };
        responses: {
            /** @description It opens */
            200: {
                headers: {
                    "Set-Cookie"?: string;
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SharedJob"];
                };
            };
            400: components["responses"]["Problem"];
            401: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    showShared: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The job under the link's id */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SharedJob"];
                };
            };
            401: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sharedCloth: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Its bytes */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "model/obj": unknown;
                };
            };
            401: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sharedPieces: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The pieces, and the fabrics of the library among theirs */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["SeenPieces"];
                };
            };
            401: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            422: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sharedPicture: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
                /** @example front.png */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Its bytes */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "image/png": unknown;
                    "image/jpeg": unknown;
                };
            };
            401: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sharedBody: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The mesh */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/octet-stream": unknown;
                };
            };
            401: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sharedResult: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
                /** @example front.png */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Its bytes */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": unknown;
                    "image/png": unknown;
                    "model/gltf-binary": unknown;
                    "model/obj": unknown;
                    "video/mp4": unknown;
                    "video/x-msvideo": unknown;
                };
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sharedStill: {
        parameters: {
            query?: {
                /** @description Pixels; the height follows */
                width?: number;
            };
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
                /** @example front.png */
                name: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A PNG */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "image/png": unknown;
                };
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    sharedReport: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description A page with nothing outside it */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/html": unknown;
                };
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    streamShared: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                /** @example l_1qedqq1nd5hfbjxpm78j */
                id: components["parameters"]["LinkId"];
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description The connection is a WebSocket now */
            101: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            410: components["responses"]["Problem"];
            426: components["responses"]["Problem"];
            429: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    adminAccounts: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description All of them */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        accounts: components["schemas"]["AdminAccount"][];
                    };
                };
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    lockAccount: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description None of their keys is good for anything */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    unlockAccount: {
        parameters: {
            query?: never;
            header?: never;
            path: {
                id: string;
            };
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Their keys are good again */
            204: {
                headers: {
                    [name: string]: unknown;
                };
                content?: never;
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            404: components["responses"]["Problem"];
            409: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    adminJobs: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description All of them */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": {
                        jobs: components["schemas"]["AdminJob"][];
                    };
                };
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    adminLoad: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description Figures of this moment */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "application/json": components["schemas"]["AdminLoad"];
                };
            };
            401: components["responses"]["Problem"];
            403: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    healthz: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Health"];
            421: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    readyz: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            200: components["responses"]["Health"];
            421: components["responses"]["Problem"];
            503: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
    metrics: {
        parameters: {
            query?: never;
            header?: never;
            path?: never;
            cookie?: never;
        };
        requestBody?: never;
        responses: {
            /** @description One figure a line */
            200: {
                headers: {
                    [name: string]: unknown;
                };
                content: {
                    "text/plain": string;
                };
            };
            421: components["responses"]["Problem"];
            default: components["responses"]["Problem"];
        };
    };
}
